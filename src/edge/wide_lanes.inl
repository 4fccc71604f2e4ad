// Pixels in lanes wide enough for sums of them: bytes in 16 bits, 16 bits in 32. Include after
// <hwy/highway.h>; compiled once per target, so without `#pragma once`.
#if defined(INK_EDGE_WIDE_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef INK_EDGE_WIDE_LANES_INL
#undef INK_EDGE_WIDE_LANES_INL
#else
#define INK_EDGE_WIDE_LANES_INL
#endif

#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class T>
using Wide = std::conditional_t<sizeof(T) == 1, std::int16_t, std::int32_t>;

template <class D, class T>
HWY_INLINE hn::Vec<D> load_wide(D d, const T* from) {
    return hn::PromoteTo(d, hn::LoadU(hn::Rebind<T, D>(), from));
}

/// Whole numbers beyond the pixel's range become its ends.
template <class D, class T>
HWY_INLINE void store_wide(D /*d*/, hn::Vec<D> value, T* to) {
    const hn::Rebind<T, D> narrow;
    hn::StoreU(hn::DemoteTo(narrow, value), narrow, to);
}

/// A pixel's three rows, each from the column on its left on.
template <class T>
struct Stencil {
    const T* up;
    const T* mid;
    const T* down;
};

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
