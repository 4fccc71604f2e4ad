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
#include "edge/decaudin_filter.h"
#include "edge/edge_image.h"
#include "edge/laplacian.h"
#include "edge/laplacian_f32x4.h"

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
    add_opencv_benchmarks();
}

}  // namespace ink::bench
