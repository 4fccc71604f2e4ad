#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "bench/benchmarks.h"
#include "core/hash.h"
#include "core/image.h"
#include "edge/decaudin_filter.h"
#include "edge/edge_image.h"
#include "edge/laplacian.h"
#include "edge/laplacian_f32x4.h"

namespace ink::bench {
namespace {

/// An image with a border of two pixels or more all round, so that filters may read beyond the
/// frame. Rows begin where cache lines do.
template <class T>
class Padded {
  public:
    static constexpr int kBorder_px = 2;
    static constexpr int kStride_px = kWidth_px + 64;

    Padded() : pixels_(kStride_px, kHeight_px + 2 * kBorder_px + 1) {
        const auto address = reinterpret_cast<std::uintptr_t>(pixels_.row(kBorder_px));
        shift_px_ = static_cast<int>((64 - address % 64) / sizeof(T));
    }
    [[nodiscard]] T* row(int y) { return pixels_.row(y + kBorder_px) + shift_px_; }
    [[nodiscard]] const T* row(int y) const { return pixels_.row(y + kBorder_px) + shift_px_; }
    [[nodiscard]] core::Image<T>& pixels() { return pixels_; }
    [[nodiscard]] core::ImageView<const T> view() const {
        return {row(0), kWidth_px, kHeight_px, kStride_px};
    }

  private:
    core::Image<T> pixels_;
    int shift_px_ = 0;
};

/// Codes as a method makes them: ramps with a step here and there.
template <class T>
Padded<T> codes(std::uint32_t seed) {
    std::mt19937 random(seed);
    Padded<T> image;
    auto& pixels = image.pixels();
    for (int y = 0; y < pixels.height_px(); ++y) {
        auto code = static_cast<std::uint32_t>(random() % 256);
        for (int x = 0; x < pixels.width_px(); ++x) {
            const auto dice = static_cast<std::uint32_t>(random());
            code = dice % 40 == 0 ? dice >> 16 : code + dice % 3;
            pixels.at(x, y) = static_cast<T>(code);
        }
    }
    return image;
}

/// The same as floats, 0..1.
template <>
Padded<float> codes<float>(std::uint32_t seed) {
    auto bytes = codes<std::uint8_t>(seed);
    Padded<float> image;
    auto& pixels = image.pixels();
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels.data()[i] = static_cast<float>(bytes.pixels().data()[i]) / 255;
    return image;
}

constexpr std::int64_t kPixels = std::int64_t{kWidth_px} * kHeight_px;

/// Bytes that a filter must read and write: each pixel of the input and of the output once.
struct Traffic {
    std::int64_t read;
    std::int64_t written;

    [[nodiscard]] std::int64_t sum() const { return read + written; }
};
constexpr Traffic kBytes{kPixels, kPixels};
constexpr Traffic kWords{2 * kPixels, kPixels};
constexpr Traffic kFullBuffer{16 * kPixels, kPixels};

/// A copy that moves as many bytes as a filter: half of the sum is read, half is written.
void time_memcpy(benchmark::State& state, const Traffic& traffic) {
    const auto size = static_cast<std::size_t>(traffic.sum() / 2);
    const std::vector<std::uint8_t> from(size, 7);
    std::vector<std::uint8_t> to(size);
    for (auto _ : state) {
        std::memcpy(to.data(), from.data(), size);
        benchmark::ClobberMemory();
    }
    state.SetLabel(core::Hasher().bytes(to.data(), to.size()).hex());
    state.SetBytesProcessed(state.iterations() * traffic.sum());
}

/// Times `filter(out)`, which must fill an image.
template <class Filter>
void time_filter(benchmark::State& state, const Traffic& traffic, const Filter& filter) {
    edge::EdgeImage out(kWidth_px, kHeight_px);
    for (auto _ : state) {
        filter(out);
        benchmark::ClobberMemory();
    }
    state.SetLabel(core::image_hash(out));
    state.SetBytesProcessed(state.iterations() * traffic.sum());
}

/// The filter as its formula has it, for the default response: |L| with two bits clipped.
template <class T>
edge::EdgeImage laplacian_by_formula(const Padded<T>& code) {
    edge::EdgeImage out(kWidth_px, kHeight_px);
    for (int y = 0; y < kHeight_px; ++y) {
        for (int x = 0; x < kWidth_px; ++x) {
            const T* mid = code.row(y) + x;
            const int sum = code.row(y - 1)[x] + code.row(y + 1)[x] + mid[-1] + mid[1];
            out.at(x, y) = static_cast<std::uint8_t>(std::min(255, std::abs(4 * *mid - sum) & ~3));
        }
    }
    return out;
}

template <class T>
void time_laplacian(benchmark::State& state, int threads) {
    const Padded<T> code = codes<T>(1);
    const auto filter = [&](edge::EdgeImage& out) {
        edge::laplacian(code.view(), out.view(), {}, threads);
    };
    edge::EdgeImage checked(kWidth_px, kHeight_px);
    filter(checked);
    if (!(checked == laplacian_by_formula(code))) {
        state.SkipWithError("the filter differs from its formula");
        return;
    }
    time_filter(state, sizeof(T) == 1 ? kBytes : kWords, filter);
}

/// Four float channels.
struct FullBuffer {
    std::array<Padded<float>, 4> planes = {
        codes<float>(1), codes<float>(2), codes<float>(3), codes<float>(4)};
};

void time_full_laplacian(benchmark::State& state) {
    const FullBuffer buffer;
    edge::FloatPlanes planes;
    for (std::size_t i = 0; i < 4; ++i)
        planes.origin[i] = buffer.planes[i].row(0);
    planes.stride = Padded<float>::kStride_px;
    time_filter(state, kFullBuffer, [&](edge::EdgeImage& out) {
        edge::laplacian_f32x4(planes, out.view(), {.threshold = 0.1F}, 1);
    });
}

/// Decaudin's two operators over four float channels, joined by the largest.
void time_decaudin(benchmark::State& state) {
    const FullBuffer buffer;
    std::array<edge::DecaudinChannel, 4> channels;
    for (std::size_t i = 0; i < 4; ++i)
        channels[i] = {buffer.planes[i].row(0), Padded<float>::kStride_px, {}};
    time_filter(state, kFullBuffer, [&](edge::EdgeImage& out) {
        edge::decaudin(channels, edge::DecaudinJoin::max, out.view(), 1);
    });
}

// OpenCV's operators on one thread, on the images that ours are timed on.

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
void time_opencv_laplacian(benchmark::State& state) {
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
void time_opencv_full_laplacian(benchmark::State& state) {
    cv::setNumThreads(1);
    FullBuffer buffer;
    cv::Mat filtered;
    cv::Mat sum;
    cv::Mat out;
    for (auto _ : state) {
        for (std::size_t i = 0; i < buffer.planes.size(); ++i) {
            cv::Laplacian(
                mat_of(buffer.planes[i]), filtered, CV_32F, 1, 1, 0, cv::BORDER_REPLICATE);
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

void add_filter_benchmarks() {
    add("memcpy/u8/1080p", time_memcpy, kBytes);
    add("memcpy/u16/1080p", time_memcpy, kWords);
    add("memcpy/f32x4/1080p", time_memcpy, kFullBuffer);
    add("filter/laplacian/u8/1080p", time_laplacian<std::uint8_t>, 1);
    add("filter/laplacian/u8/1080p/threads:2", time_laplacian<std::uint8_t>, 2);
    add("filter/laplacian/u16/1080p", time_laplacian<std::uint16_t>, 1);
    add("filter/laplacian/f32x4/1080p", time_full_laplacian);
    add("filter/decaudin/1080p", time_decaudin);
    add("opencv/laplacian/u8/1080p", time_opencv_laplacian<std::uint8_t>);
    add("opencv/laplacian/u16/1080p", time_opencv_laplacian<std::uint16_t>);
    add("opencv/laplacian/f32x4/1080p", time_opencv_full_laplacian);
}

}  // namespace ink::bench
