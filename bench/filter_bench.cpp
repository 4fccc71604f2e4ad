#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "bench/bench_scene.h"
#include "bench/benchmarks.h"
#include "core/hash.h"
#include "edge/decaudin_filter.h"
#include "edge/edge_image.h"
#include "edge/laplacian.h"

namespace ink::bench {
namespace {

constexpr int kBorder_px = 2;
constexpr int kStride_px = kWidth_px + 64;

/// A picture with a border of two pixels or more all round, so that filters may read beyond the
/// frame. Rows begin where cache lines do.
template <class T>
class Padded {
  public:
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
    Padded<T> picture;
    auto& pixels = picture.pixels();
    for (int y = 0; y < pixels.height_px(); ++y) {
        auto code = static_cast<std::uint32_t>(random() % 256);
        for (int x = 0; x < pixels.width_px(); ++x) {
            const auto dice = static_cast<std::uint32_t>(random());
            code = dice % 40 == 0 ? dice >> 16 : code + dice % 3;
            pixels.at(x, y) = static_cast<T>(code);
        }
    }
    return picture;
}

template <class T>
void laplacian(const Padded<T>& code, edge::EdgeImage& out) {
    edge::laplacian(code.view(), out.view(), {}, 1);
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
void time_laplacian(benchmark::State& state) {
    const Padded<T> code = codes<T>(1);
    edge::EdgeImage out(kWidth_px, kHeight_px);
    laplacian(code, out);
    if (!(out == laplacian_by_formula(code))) {
        state.SkipWithError("the filter differs from its formula");
        return;
    }
    for (auto _ : state) {
        laplacian(code, out);
        benchmark::ClobberMemory();
    }
    state.SetLabel(core::image_hash(out));
    state.SetBytesProcessed(state.iterations() * kWidth_px * kHeight_px *
                            static_cast<std::int64_t>(sizeof(T) + 1));
}

void time_memcpy(benchmark::State& state) {
    const edge::EdgeImage from(kWidth_px, kHeight_px, 7);
    edge::EdgeImage to(kWidth_px, kHeight_px);
    for (auto _ : state) {
        std::memcpy(to.data(), from.data(), from.size());
        benchmark::ClobberMemory();
    }
    state.SetLabel(core::image_hash(to));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(2 * from.size()));
}

/// OpenCV's own operator, then scaled and clipped to eight bits, on one thread.
template <class T>
void time_opencv_laplacian(benchmark::State& state) {
    cv::setNumThreads(1);
    Padded<T> code = codes<T>(1);
    const cv::Mat from(
        kHeight_px, kWidth_px, cv::DataType<T>::type, code.row(0), kStride_px * sizeof(T));
    // OpenCV has no 16-bit result for 16-bit input.
    const int depth = sizeof(T) == 1 ? CV_16S : CV_32F;
    cv::Mat filtered;
    cv::Mat out;
    for (auto _ : state) {
        cv::Laplacian(from, filtered, depth, 1, 1, 0, cv::BORDER_REPLICATE);
        cv::convertScaleAbs(filtered, out);
        benchmark::ClobberMemory();
    }
    edge::EdgeImage picture(kWidth_px, kHeight_px);
    std::memcpy(picture.data(), out.data, picture.size());
    state.SetLabel(core::image_hash(picture));
}

/// Decaudin's two operators over four float channels, joined by the largest.
class DecaudinFilter {
  public:
    DecaudinFilter() {
        for (std::size_t i = 0; i < channels_.size(); ++i) {
            auto code = codes<std::uint8_t>(static_cast<std::uint32_t>(i + 1));
            auto& pixels = channels_[i].pixels();
            std::transform(code.pixels().data(),
                           code.pixels().data() + pixels.size(),
                           pixels.data(),
                           [](std::uint8_t value) { return static_cast<float>(value) / 255; });
        }
    }

    void run(edge::EdgeImage& out, int threads) {
        std::array<edge::DecaudinChannel, 4> channels;
        for (std::size_t i = 0; i < channels.size(); ++i)
            channels[i] = {channels_[i].row(0), kStride_px, {}};
        edge::decaudin(channels, edge::DecaudinJoin::max, out.view(), threads);
    }

  private:
    std::array<Padded<float>, 4> channels_;
};

void time_decaudin(benchmark::State& state) {
    DecaudinFilter filter;
    edge::EdgeImage out(kWidth_px, kHeight_px);
    for (auto _ : state) {
        filter.run(out, 1);
        benchmark::ClobberMemory();
    }
    state.SetLabel(core::image_hash(out));
}

}  // namespace

void add_filter_benchmarks() {
    benchmark::RegisterBenchmark("memcpy/u8/1080p", time_memcpy);
    benchmark::RegisterBenchmark("filter/laplacian/u8/1080p", time_laplacian<std::uint8_t>);
    benchmark::RegisterBenchmark("filter/laplacian/u16/1080p", time_laplacian<std::uint16_t>);
    benchmark::RegisterBenchmark("opencv/laplacian/u8/1080p", time_opencv_laplacian<std::uint8_t>);
    benchmark::RegisterBenchmark("opencv/laplacian/u16/1080p",
                                 time_opencv_laplacian<std::uint16_t>);
    benchmark::RegisterBenchmark("filter/decaudin/1080p", time_decaudin);
}

}  // namespace ink::bench
