#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/roberts_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "edge/roberts.h"
#include "edge/row_bands.h"
#include "edge/vector_loops.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D, class V = hn::Vec<D>>
HWY_INLINE V cross_sum(D, V upper_left, V upper_right, V lower_left, V lower_right) {
    if constexpr (hwy::IsFloat<hn::TFromD<D>>()) {
        return hn::Add(hn::AbsDiff(upper_left, lower_right), hn::AbsDiff(upper_right, lower_left));
    } else {
        const V falling =
            hn::Sub(hn::Max(upper_left, lower_right), hn::Min(upper_left, lower_right));
        const V rising =
            hn::Sub(hn::Max(upper_right, lower_left), hn::Min(upper_right, lower_left));
        return hn::SaturatedAdd(falling, rising);
    }
}

template <class T>
void cross_rows(const core::ImageView<const T>& values, const core::ImageView<T>& out) {
    for (int y = 0; y < out.height_px; ++y) {
        const T* upper = values.row(y);
        const T* lower = upper + values.stride;
        T* to = out.row(y);
        constexpr int kLanes = HWY_LANES(T);
        cover<T, kLanes>(out.width_px, kLanes, [=](auto d, int x) HWY_ATTR {
            const auto sum = cross_sum(d,
                                       hn::LoadU(d, upper + x),
                                       hn::LoadU(d, upper + x + 1),
                                       hn::LoadU(d, lower + x),
                                       hn::LoadU(d, lower + x + 1));
            hn::StoreU(sum, d, to + x);
        });
    }
}

void cross_u8(const core::ImageView<const std::uint8_t>& values,
              const core::ImageView<std::uint8_t>& out) {
    cross_rows(values, out);
}
void cross_u16(const core::ImageView<const std::uint16_t>& values,
               const core::ImageView<std::uint16_t>& out) {
    cross_rows(values, out);
}
void cross_f32(const core::ImageView<const float>& values, const core::ImageView<float>& out) {
    cross_rows(values, out);
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {
namespace {

HWY_EXPORT(cross_u8);
HWY_EXPORT(cross_u16);
HWY_EXPORT(cross_f32);

}  // namespace

void roberts(const core::ImageView<const std::uint8_t>& values,
             const core::ImageView<std::uint8_t>& out,
             int threads) {
    filter_row_bands(values, out, threads, HWY_DYNAMIC_DISPATCH(cross_u8));
}

void roberts(const core::ImageView<const std::uint16_t>& values,
             const core::ImageView<std::uint16_t>& out,
             int threads) {
    filter_row_bands(values, out, threads, HWY_DYNAMIC_DISPATCH(cross_u16));
}

void roberts(const core::ImageView<const float>& values,
             const core::ImageView<float>& out,
             int threads) {
    filter_row_bands(values, out, threads, HWY_DYNAMIC_DISPATCH(cross_f32));
}

}  // namespace ink::edge
#endif
