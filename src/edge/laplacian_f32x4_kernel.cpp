#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/laplacian_f32x4_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cassert>

#include "edge/laplacian_f32x4.h"
#include "edge/row_bands.h"
#include "edge/vector_loops.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
HWY_INLINE hn::Vec<D> laplacian_of(D d, const float* at, std::ptrdiff_t stride) {
    const auto four = hn::Mul(hn::Set(d, 4.0F), hn::LoadU(d, at));
    const auto column = hn::Add(hn::LoadU(d, at - stride), hn::LoadU(d, at + stride));
    const auto row = hn::Add(hn::LoadU(d, at - 1), hn::LoadU(d, at + 1));
    return hn::Sub(hn::Sub(four, column), row);
}

/// One term of S.
template <LaplacianSum kSum, class D>
HWY_INLINE hn::Vec<D> term(D d, const float* at, std::ptrdiff_t stride, float weight) {
    const auto laplacian = laplacian_of(d, at, stride);
    if constexpr (kSum == LaplacianSum::of_absolutes) {
        return hn::Mul(hn::Set(d, weight), hn::Abs(laplacian));
    } else {
        return hn::Mul(hn::Set(d, weight), laplacian);
    }
}

template <LaplacianSum kSum>
void filter(const FloatPlanes& planes,
            const core::ImageView<std::uint8_t>& out,
            const FullLaplacianResponse& response) {
    const float scale = 255 / response.full;
    for (int y = 0; y < out.height_px; ++y) {
        const std::ptrdiff_t first = y * planes.stride;
        const std::ptrdiff_t stride = planes.stride;
        const std::array<const float*, 4> at = planes.origin;
        const std::array<float, 4> weights = response.weights;
        const float threshold = response.threshold;
        std::uint8_t* to = out.row(y);
        cover<float, HWY_LANES(float)>(out.width_px, HWY_LANES(float), [=](auto d, int x) HWY_ATTR {
            const hn::Rebind<std::int32_t, decltype(d)> di;
            const hn::Rebind<std::uint8_t, decltype(d)> du8;
            auto sum = term<kSum>(d, at[0] + first + x, stride, weights[0]);
            for (std::size_t i = 1; i < 4; ++i)
                sum = hn::Add(sum, term<kSum>(d, at[i] + first + x, stride, weights[i]));
            if constexpr (kSum == LaplacianSum::absolute_of_sum) sum = hn::Abs(sum);
            const auto full = hn::Set(d, 255.0F);
            const auto strength = hn::Min(hn::Mul(sum, hn::Set(d, scale)), full);
            const auto is_line = hn::Ge(sum, hn::Set(d, threshold));
            const auto rounded = hn::IfThenElseZero(is_line, hn::Add(strength, hn::Set(d, 0.5F)));
            hn::StoreU(hn::DemoteTo(du8, hn::ConvertTo(di, rounded)), du8, to + x);
        });
    }
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
