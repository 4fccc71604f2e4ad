// OpenCV's operators on one thread, on the images that ours are timed on.

#include <benchmark/benchmark.h>

#include <array>
#include <cstring>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "bench/benchmarks.h"
#include "bench/filter_images.h"
#include "core/hash.h"
#include "edge/edge_image.h"

namespace ink::bench {
namespace {

template <class T>
cv::Mat mat_of(Padded<T>& image) {
    return {kHeight_px,
            kWidth_px,
            cv::DataType<T>::type,
            image.row(0),
            Padded<T>::kStride_px * sizeof(T)};
}

/// A hash of the last image as bytes.
void label(benchmark::State& state, const cv::Mat& bytes) {
    edge::EdgeImage image(kWidth_px, kHeight_px);
    std::memcpy(image.data(), bytes.data, image.size());
    state.SetLabel(core::image_hash(image));
}

/// The Laplacian, then scaled and clipped to eight bits.
template <class T>
void time_laplacian(benchmark::State& state) {
    cv::setNumThreads(1);
    Padded<T> code = codes<T>(1);
    const cv::Mat from = mat_of(code);
    // OpenCV has no 16-bit result for 16-bit input.
    const int depth = sizeof(T) == 1 ? CV_16S : CV_32F;
    cv::Mat filtered;
    cv::Mat out;
    for (auto _ : state) {
        cv::Laplacian(from, filtered, depth, 1, 1, 0, cv::BORDER_REPLICATE);
        cv::convertScaleAbs(filtered, out);
        benchmark::ClobberMemory();
    }
    label(state, out);
}

/// Four channels: |L| summed, then scaled to eight bits.
void time_full_laplacian(benchmark::State& state) {
    cv::setNumThreads(1);
    std::array<Padded<float>, 4> planes = {
        codes<float>(1), codes<float>(2), codes<float>(3), codes<float>(4)};
    cv::Mat filtered;
    cv::Mat sum;
    cv::Mat out;
    for (auto _ : state) {
        for (std::size_t i = 0; i < planes.size(); ++i) {
            cv::Laplacian(mat_of(planes[i]), filtered, CV_32F, 1, 1, 0, cv::BORDER_REPLICATE);
            if (i == 0) {
                sum = cv::abs(filtered);
            } else {
                sum += cv::abs(filtered);
            }
        }
        cv::convertScaleAbs(sum, out, 255);
        benchmark::ClobberMemory();
    }
    label(state, out);
}

}  // namespace

void add_opencv_benchmarks() {
    add("opencv/laplacian/u8/1080p", time_laplacian<std::uint8_t>);
    add("opencv/laplacian/u16/1080p", time_laplacian<std::uint16_t>);
    add("opencv/laplacian/f32x4/1080p", time_full_laplacian);
}

}  // namespace ink::bench
