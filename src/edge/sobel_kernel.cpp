#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/sobel_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "edge/row_bands.h"
#include "edge/sobel.h"
#include "edge/vector_loops.inl"
#include "edge/wide_lanes.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// (|vertical| + |horizontal|) / 8: fits the pixel's type.
template <class D, class T>
HWY_INLINE hn::Vec<D> first_differential(D d, const Stencil<T>& at) {
    using V = hn::Vec<D>;
    const auto weighted = [d](const T* one, const T* two, const T* three) HWY_ATTR {
        const V middle = load_wide(d, two);
        return hn::Add(hn::Add(load_wide(d, one), hn::Add(middle, middle)), load_wide(d, three));
    };
    const V above = weighted(at.up - 1, at.up, at.up + 1);
    const V below = weighted(at.down - 1, at.down, at.down + 1);
    const V right = weighted(at.up + 1, at.mid + 1, at.down + 1);
    const V left = weighted(at.up - 1, at.mid - 1, at.down - 1);
    const V sum = hn::Add(hn::Abs(hn::Sub(above, below)), hn::Abs(hn::Sub(right, left)));
    if constexpr (hwy::IsFloat<T>()) {
        return hn::Mul(sum, hn::Set(d, 0.125F));
    } else {
        return hn::ShiftRight<3>(sum);
    }
}

/// A third of a number below 2^19, what is over dropped.
template <class D>
HWY_INLINE hn::Vec<D> third(D d, hn::Vec<D> value) {
    using Lane = hn::TFromD<D>;
    if constexpr (hwy::IsFloat<Lane>()) {
        return hn::Div(value, hn::Set(d, 3.0F));
    } else if constexpr (sizeof(Lane) == 2) {
        return hn::MulHigh(value, hn::Set(d, 21846));  // exact below 32768
    } else {
        // Exact in floats: no quotient with a rest comes within half a step of the next number.
        const hn::Rebind<float, D> df;
        return hn::ConvertTo(d, hn::Div(hn::ConvertTo(df, value), hn::Set(df, 3.0F)));
    }
}

template <class D, class T>
HWY_INLINE hn::Vec<D> second_differential(D d, const Stencil<T>& at) {
    using Lane = hn::TFromD<D>;
    using V = hn::Vec<D>;
    V sum = hn::Add(load_wide(d, at.up - 1), load_wide(d, at.up));
    sum = hn::Add(sum, load_wide(d, at.up + 1));
    sum = hn::Add(sum, load_wide(d, at.mid - 1));
    sum = hn::Add(sum, load_wide(d, at.mid + 1));
    sum = hn::Add(sum, load_wide(d, at.down - 1));
    sum = hn::Add(sum, load_wide(d, at.down));
    sum = hn::Add(sum, load_wide(d, at.down + 1));
    V eight = load_wide(d, at.mid);
    if constexpr (hwy::IsFloat<Lane>()) {
        eight = hn::Mul(eight, hn::Set(d, 8.0F));
    } else {
        eight = hn::ShiftLeft<3>(eight);
    }
    return third(d, hn::Abs(hn::Sub(eight, sum)));
}

template <Differential kDifferential, class T>
void differentiate(const core::ImageView<const T>& values, const core::ImageView<T>& out) {
    constexpr int kLanes = HWY_LANES(Wide<T>);
    for (int y = 0; y < out.height_px; ++y) {
        const T* mid = values.row(y);
        const Stencil<T> row{mid - values.stride, mid, mid + values.stride};
        T* to = out.row(y);
        cover<Wide<T>, kLanes>(out.width_px, kLanes, [=](auto d, int x) HWY_ATTR {
            const Stencil<T> at{row.up + x, row.mid + x, row.down + x};
            if constexpr (kDifferential == Differential::first) {
                store_wide(d, first_differential(d, at), to + x);
            } else {
                store_wide(d, second_differential(d, at), to + x);
            }
        });
    }
}

template <class T>
void differentiate_as(const core::ImageView<const T>& values,
                      Differential differential,
                      const core::ImageView<T>& out) {
    if (differential == Differential::first) {
        return differentiate<Differential::first>(values, out);
    }
    differentiate<Differential::second>(values, out);
}

void sobel_u8(const core::ImageView<const std::uint8_t>& values,
              Differential differential,
              const core::ImageView<std::uint8_t>& out) {
    differentiate_as(values, differential, out);
}
void sobel_u16(const core::ImageView<const std::uint16_t>& values,
               Differential differential,
               const core::ImageView<std::uint16_t>& out) {
    differentiate_as(values, differential, out);
}
void sobel_f32(const core::ImageView<const float>& values,
               Differential differential,
               const core::ImageView<float>& out) {
    differentiate_as(values, differential, out);
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {
namespace {

HWY_EXPORT(sobel_u8);
HWY_EXPORT(sobel_u16);
HWY_EXPORT(sobel_f32);

}  // namespace

void sobel(const core::ImageView<const std::uint8_t>& values,
           Differential differential,
           const core::ImageView<std::uint8_t>& out,
           int threads) {
    const auto kernel = HWY_DYNAMIC_DISPATCH(sobel_u8);
    filter_row_bands(values, out, threads, [&](const auto& from, const auto& to) {
        kernel(from, differential, to);
    });
}

void sobel(const core::ImageView<const std::uint16_t>& values,
           Differential differential,
           const core::ImageView<std::uint16_t>& out,
           int threads) {
    const auto kernel = HWY_DYNAMIC_DISPATCH(sobel_u16);
    filter_row_bands(values, out, threads, [&](const auto& from, const auto& to) {
        kernel(from, differential, to);
    });
}

void sobel(const core::ImageView<const float>& values,
           Differential differential,
           const core::ImageView<float>& out,
           int threads) {
    const auto kernel = HWY_DYNAMIC_DISPATCH(sobel_f32);
    filter_row_bands(values, out, threads, [&](const auto& from, const auto& to) {
        kernel(from, differential, to);
    });
}

}  // namespace ink::edge
#endif
