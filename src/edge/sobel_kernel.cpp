#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/sobel_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "edge/row_bands.h"
#include "edge/sobel.h"
#include "edge/vector_loops.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// (|vertical| + |horizontal|) / 8.
struct First {
    template <class D>
    HWY_INLINE hn::Vec<D> operator()(D d, const float* up, const float* mid, const float* down) {
        using V = hn::Vec<D>;
        const auto weighted = [d](const float* one, const float* two, const float* three) HWY_ATTR {
            const V middle = hn::LoadU(d, two);
            return hn::Add(hn::Add(hn::LoadU(d, one), hn::Add(middle, middle)),
                           hn::LoadU(d, three));
        };
        const V above = weighted(up - 1, up, up + 1);
        const V below = weighted(down - 1, down, down + 1);
        const V right = weighted(up + 1, mid + 1, down + 1);
        const V left = weighted(up - 1, mid - 1, down - 1);
        const V sum = hn::Add(hn::Abs(hn::Sub(above, below)), hn::Abs(hn::Sub(right, left)));
        return hn::Mul(sum, hn::Set(d, 0.125F));
    }
};

/// A third of eight times the middle less all around it.
struct Second {
    template <class D>
    HWY_INLINE hn::Vec<D> operator()(D d, const float* up, const float* mid, const float* down) {
        hn::Vec<D> sum = hn::Add(hn::LoadU(d, up - 1), hn::LoadU(d, up));
        for (const float* at : {up + 1, mid - 1, mid + 1, down - 1, down, down + 1})
            sum = hn::Add(sum, hn::LoadU(d, at));
        const auto eight = hn::Mul(hn::LoadU(d, mid), hn::Set(d, 8.0F));
        return hn::Div(hn::Abs(hn::Sub(eight, sum)), hn::Set(d, 3.0F));
    }
};

template <class Response>
void differentiate(const core::ImageView<const float>& values, const core::ImageView<float>& out) {
    constexpr int kLanes = HWY_LANES(float);
    for (int y = 0; y < out.height_px; ++y) {
        const float* mid = values.row(y);
        const float* up = mid - values.stride;
        const float* down = mid + values.stride;
        float* to = out.row(y);
        cover<float, kLanes>(out.width_px, kLanes, [=](auto d, int x) HWY_ATTR {
            hn::StoreU(Response()(d, up + x, mid + x, down + x), d, to + x);
        });
    }
}

void differentiate_once(const core::ImageView<const float>& values,
                        const core::ImageView<float>& out) {
    differentiate<First>(values, out);
}

void differentiate_twice(const core::ImageView<const float>& values,
                         const core::ImageView<float>& out) {
    differentiate<Second>(values, out);
}

void cross_rows(const core::ImageView<const float>& values, const core::ImageView<float>& out) {
    for (int y = 0; y < out.height_px; ++y) {
        const float* upper = values.row(y);
        const float* lower = upper + values.stride;
        float* to = out.row(y);
        constexpr int kLanes = HWY_LANES(float);
        cover<float, kLanes>(out.width_px, kLanes, [=](auto d, int x) HWY_ATTR {
            const auto falling = hn::AbsDiff(hn::LoadU(d, upper + x), hn::LoadU(d, lower + x + 1));
            const auto rising = hn::AbsDiff(hn::LoadU(d, upper + x + 1), hn::LoadU(d, lower + x));
            hn::StoreU(hn::Add(falling, rising), d, to + x);
        });
    }
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {

namespace {

HWY_EXPORT(differentiate_once);
HWY_EXPORT(differentiate_twice);

}  // namespace

void sobel(const core::ImageView<const float>& values,
           Differential differential,
           const core::ImageView<float>& out,
           int threads) {
    filter_row_bands(values,
                     out,
                     threads,
                     differential == Differential::first
                         ? HWY_DYNAMIC_DISPATCH(differentiate_once)
                         : HWY_DYNAMIC_DISPATCH(differentiate_twice));
}

namespace {

HWY_EXPORT(cross_rows);

}  // namespace

void roberts(const core::ImageView<const float>& values,
             const core::ImageView<float>& out,
             int threads) {
    filter_row_bands(values, out, threads, HWY_DYNAMIC_DISPATCH(cross_rows));
}

}  // namespace ink::edge
#endif
