#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/laplacian_f32x4_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <hwy/cache_control.h>
#include <cassert>

#include "edge/laplacian_f32x4.h"
#include "edge/row_bands.h"
#include "edge/vector_loops.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// How far ahead of the filter memory is asked for, in floats: rows of four planes are more streams
/// than the machine follows by itself.
constexpr int kAhead_px = 64;

/// One channel's part of S for one pixel of each of `kRows` rows, added to `sums` (or put there).
template <LaplacianSum kSum, int kRows, class D, class V = hn::Vec<D>>
HWY_INLINE void add_terms(
    D d, const float* at, std::ptrdiff_t stride, V weight, V* sums, bool is_first) {
    V up = hn::LoadU(d, at - stride);
    V mid = hn::LoadU(d, at);
    for (int y = 0; y < kRows; ++y) {
        const V down = hn::LoadU(d, at + stride);
        hwy::Prefetch(at + stride + kAhead_px);
        const V row = hn::Add(hn::LoadU(d, at - 1), hn::LoadU(d, at + 1));
        const V four = hn::Mul(hn::Set(d, 4.0F), mid);
        V term = hn::Sub(hn::Sub(four, hn::Add(up, down)), row);
        if constexpr (kSum == LaplacianSum::of_absolutes) term = hn::Abs(term);
        term = hn::Mul(weight, term);
        sums[y] = is_first ? term : hn::Add(sums[y], term);
        up = mid;
        mid = down;
        at += stride;
    }
}

template <LaplacianSum kSum, class D>
HWY_INLINE void store_response(D d,
                               hn::Vec<D> sum,
                               const FullLaplacianResponse& r,
                               std::uint8_t* out) {
    const hn::Rebind<std::int32_t, D> di;
    const hn::Rebind<std::uint8_t, D> du8;
    if constexpr (kSum == LaplacianSum::absolute_of_sum) sum = hn::Abs(sum);
    const auto scaled = hn::Mul(sum, hn::Set(d, 255 / r.full));
    const auto edge_response = hn::Add(hn::Min(scaled, hn::Set(d, 255.0F)), hn::Set(d, 0.5F));
    const auto line = hn::IfThenElseZero(hn::Ge(sum, hn::Set(d, r.threshold)), edge_response);
    hn::StoreU(hn::DemoteTo(du8, hn::ConvertTo(di, line)), du8, out);
}

/// `kRows` rows at once, so that a row is fetched once for the three that need it.
template <LaplacianSum kSum, int kRows>
void filter_rows(const FloatPlanes& given,
                 const FullLaplacianResponse& given_response,
                 const core::ImageView<std::uint8_t>& out,
                 int y0) {
    const FloatPlanes planes = given;
    const FullLaplacianResponse response = given_response;
    const std::ptrdiff_t first = y0 * planes.stride;
    std::uint8_t* to = out.row(y0);
    const std::ptrdiff_t to_stride = out.stride;
    constexpr int kLanes = HWY_LANES(float);
    cover<float, kLanes>(out.width_px, kLanes, [=](auto d, int x) HWY_ATTR {
        hn::Vec<decltype(d)> sums[kRows];
        for (std::size_t i = 0; i < 4; ++i) {
            const float* at = planes.origin[i] + first + x;
            const auto weight = hn::Set(d, response.weights[i]);
            add_terms<kSum, kRows>(d, at, planes.stride, weight, sums, i == 0);
        }
        for (int y = 0; y < kRows; ++y)
            store_response<kSum>(d, sums[y], response, to + y * to_stride + x);
    });
}

template <LaplacianSum kSum>
void filter(const FloatPlanes& planes,
            const core::ImageView<std::uint8_t>& out,
            const FullLaplacianResponse& response) {
    constexpr int kBlock = 4;
    int y = 0;
    for (; y + kBlock <= out.height_px; y += kBlock)
        filter_rows<kSum, kBlock>(planes, response, out, y);
    for (; y < out.height_px; ++y)
        filter_rows<kSum, 1>(planes, response, out, y);
}

void filter_planes(const FloatPlanes& planes,
                   const core::ImageView<std::uint8_t>& out,
                   const FullLaplacianResponse& response) {
    if (response.sum == LaplacianSum::of_absolutes) {
        return filter<LaplacianSum::of_absolutes>(planes, out, response);
    }
    filter<LaplacianSum::absolute_of_sum>(planes, out, response);
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {

HWY_EXPORT(filter_planes);

void laplacian_f32x4(const FloatPlanes& planes,
                     const core::ImageView<std::uint8_t>& out,
                     const FullLaplacianResponse& response,
                     int threads) {
    assert(response.full > 0);
    for_row_bands(out.height_px, threads, [&](int y0, int y1) {
        FloatPlanes band = planes;
        for (const float*& origin : band.origin)
            origin += y0 * planes.stride;
        const core::ImageView<std::uint8_t> to{out.row(y0), out.width_px, y1 - y0, out.stride};
        HWY_DYNAMIC_DISPATCH(filter_planes)(band, to, response);
    });
}

}  // namespace ink::edge
#endif
