#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bench/bench_scene.h"
#include "bench/benchmarks.h"
#include "bench/filter_images.h"
#include "core/hash.h"
#include "edge/binomial_blur.h"
#include "edge/decaudin_filter.h"
#include "edge/edge_image.h"
#include "edge/laplacian.h"
#include "edge/laplacian_f32x4.h"
#include "edge/roberts.h"
#include "edge/sobel.h"
#include "edge/threshold.h"

namespace ink::bench {
namespace {

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

/// Times `filter(out, threads)`, which must fill an image of `T`.
template <class T, class Filter>
void time_filter(benchmark::State& state, const Traffic& traffic, const Filter& filter) {
    core::Image<T> out(kWidth_px, kHeight_px);
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
    time_filter<std::uint8_t>(state, sizeof(T) == 1 ? kBytes : kWords, filter);
}

/// Four float channels.
struct FullBuffer {
    std::array<Padded<float>, 4> planes = {
        codes<float>(1), codes<float>(2), codes<float>(3), codes<float>(4)};
};

void time_full_laplacian(benchmark::State& state, int threads) {
    const FullBuffer buffer;
    edge::FloatPlanes planes;
    for (std::size_t i = 0; i < 4; ++i)
        planes.origin[i] = buffer.planes[i].row(0);
    planes.stride = Padded<float>::kStride_px;
    time_filter<std::uint8_t>(state, kFullBuffer, [&](edge::EdgeImage& out) {
        edge::laplacian_f32x4(planes, out.view(), {.threshold = 0.1F}, threads);
    });
}

/// Decaudin's two operators over four float channels, joined by the largest.
void time_decaudin(benchmark::State& state, int threads) {
    const FullBuffer buffer;
    std::array<edge::DecaudinChannel, 4> channels;
    for (std::size_t i = 0; i < 4; ++i)
        channels[i] = {buffer.planes[i].row(0), Padded<float>::kStride_px, {}};
    time_filter<std::uint8_t>(state, kFullBuffer, [&](edge::EdgeImage& out) {
        edge::decaudin(channels, edge::DecaudinJoin::max, out.view(), threads);
    });
}

template <class T>
constexpr Traffic same_type() {
    constexpr std::int64_t kSize = sizeof(T);
    return {kSize * kPixels, kSize * kPixels};
}

void time_roberts(benchmark::State& state, int threads) {
    const Padded<float> values = codes<float>(1);
    time_filter<float>(state, same_type<float>(), [&](core::Image<float>& out) {
        edge::roberts(values.view(), out.view(), threads);
    });
}

template <edge::Differential kDifferential>
void time_sobel(benchmark::State& state, int threads) {
    const Padded<float> values = codes<float>(1);
    time_filter<float>(state, same_type<float>(), [&](core::Image<float>& out) {
        edge::sobel(values.view(), kDifferential, out.view(), threads);
    });
}

template <class T>
void time_blur(benchmark::State& state, int threads) {
    const Padded<T> values = codes<T>(1);
    time_filter<T>(state, same_type<T>(), [&](core::Image<T>& out) {
        edge::binomial_blur(values.view(), out.view(), 0, threads);
    });
}

void time_threshold(benchmark::State& state, int threads) {
    const Padded<std::uint8_t> edge_responses = codes<std::uint8_t>(1);
    time_filter<std::uint8_t>(state, kBytes, [&](edge::EdgeImage& out) {
        edge::threshold(edge_responses.view(), 128, out.view(), threads);
    });
}

/// `name` on one thread, and `name/threads:2`.
void add(const std::string& name, void (*run)(benchmark::State&, int)) {
    benchmark::RegisterBenchmark(name.c_str(), run, 1);
    benchmark::RegisterBenchmark((name + "/threads:2").c_str(), run, 2);
}

}  // namespace

void add_filter_benchmarks() {
    using edge::Differential;
    benchmark::RegisterBenchmark("memcpy/u8/1080p", time_memcpy, kBytes);
    benchmark::RegisterBenchmark("memcpy/u16/1080p", time_memcpy, kWords);
    benchmark::RegisterBenchmark("memcpy/f32x4/1080p", time_memcpy, kFullBuffer);
    add("filter/laplacian/u8/1080p", time_laplacian<std::uint8_t>);
    add("filter/laplacian/u16/1080p", time_laplacian<std::uint16_t>);
    add("filter/laplacian/f32x4/1080p", time_full_laplacian);
    add("filter/decaudin/1080p", time_decaudin);
    add("filter/roberts/f32/1080p", time_roberts);
    add("filter/sobel/f32/1080p", time_sobel<Differential::first>);
    add("filter/sobel_second/f32/1080p", time_sobel<Differential::second>);
    add("filter/blur/u8/1080p", time_blur<std::uint8_t>);
    add("filter/blur/u16/1080p", time_blur<std::uint16_t>);
    add("filter/threshold/u8/1080p", time_threshold);
    add_opencv_benchmarks();
}

}  // namespace ink::bench
