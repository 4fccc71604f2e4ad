#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/binomial_blur_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "edge/binomial_blur_kernel.h"
#include "edge/vector_loops.inl"
#include "edge/wide_lanes.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A neighbour as it counts in the sum: as it is, or by its shortest way round from the middle one.
template <bool kWraps, class D>
struct Neighbour {
    D d;
    hn::Vec<D> mid;
    int sign_shift;

    template <class T>
    HWY_INLINE hn::Vec<D> operator()(const T* at) const {
        const auto value = load_wide(d, at);
        if constexpr (!kWraps) return value;
        const auto way = hn::ShiftLeftSame(hn::Sub(value, mid), sign_shift);
        return hn::ShiftRightSame(way, sign_shift);
    }
};

template <bool kWraps, class D, class T>
HWY_INLINE hn::Vec<D> blurred(D d, const Stencil<T>& at, int code_bits) {
    using Lane = Wide<T>;
    const auto mid = load_wide(d, at.mid);
    const int lane_bits = 8 * static_cast<int>(sizeof(Lane));
    const Neighbour<kWraps, D> of{d, mid, lane_bits - code_bits};
    const auto corners =
        hn::Add(hn::Add(of(at.up - 1), of(at.up + 1)), hn::Add(of(at.down - 1), of(at.down + 1)));
    const auto sides =
        hn::Add(hn::Add(of(at.up), of(at.down)), hn::Add(of(at.mid - 1), of(at.mid + 1)));
    const auto ring = hn::Add(hn::Add(corners, hn::Add(sides, sides)), hn::Set(d, Lane{8}));
    if constexpr (kWraps) {
        const auto mask = hn::Set(d, static_cast<Lane>((std::int64_t{1} << code_bits) - 1));
        return hn::And(hn::Add(mid, hn::ShiftRight<4>(ring)), mask);
    } else {
        return hn::ShiftRight<4>(hn::Add(ring, hn::ShiftLeft<2>(mid)));
    }
}

template <bool kWraps, class T>
void blur_row(const BlurRows<T>& given, int y) {
    const std::ptrdiff_t by = y * given.stride;
    const Stencil<T> row{given.up + by, given.mid + by, given.down + by};
    T* out = given.out + y * given.out_stride;
    const int code_bits = given.code_bits;
    constexpr int kLanes = HWY_LANES(Wide<T>);
    cover<Wide<T>, kLanes>(given.width, kLanes, [=](auto d, int x) HWY_ATTR {
        const Stencil<T> at{row.up + x, row.mid + x, row.down + x};
        store_wide(d, blurred<kWraps>(d, at, code_bits), out + x);
    });
}

template <class T>
void blur(const BlurRows<T>& rows) {
    for (int y = 0; y < rows.height; ++y) {
        if (rows.code_bits == 0) {
            blur_row<false>(rows, y);
        } else {
            blur_row<true>(rows, y);
        }
    }
}

void blur_u8(const BlurRows<std::uint8_t>& rows) {
    blur(rows);
}
void blur_u16(const BlurRows<std::uint16_t>& rows) {
    blur(rows);
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {

HWY_EXPORT(blur_u8);
HWY_EXPORT(blur_u16);

void blur_rows(const BlurRows<std::uint8_t>& rows) {
    HWY_DYNAMIC_DISPATCH(blur_u8)(rows);
}

void blur_rows(const BlurRows<std::uint16_t>& rows) {
    HWY_DYNAMIC_DISPATCH(blur_u16)(rows);
}

}  // namespace ink::edge
#endif
