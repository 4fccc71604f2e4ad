// Loops over a row in vectors, for kernels: include inside HWY_BEFORE_NAMESPACE's file, after
// <hwy/highway.h>. Compiled once per target, so without `#pragma once`.
#if defined(INK_EDGE_VECTOR_LOOPS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef INK_EDGE_VECTOR_LOOPS_INL
#undef INK_EDGE_VECTOR_LOOPS_INL
#else
#define INK_EDGE_VECTOR_LOOPS_INL
#endif

#include <algorithm>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Calls body(d, x) for vectors that cover [0, width) and nothing else. The last one may cover
/// pixels a second time, so `body` must not read what it writes. width >= Lanes(d).
///
/// `first_step` (1..Lanes(d)) is the way from the first vector to the second; the others follow
/// side by side, so that it decides their alignment.
template <class D, class Body>
HWY_INLINE void cover_with(D d, int width, int first_step, Body body) {
    const int lanes = static_cast<int>(hn::Lanes(d));
    const int last = width - lanes;
    int step = first_step;
    for (int x = 0;;) {
        body(d, x);
        if (x == last) return;
        x = std::min(x + step, last);
        step = lanes;
    }
}

/// The same for any width, in narrower vectors where it is less than one of `kLanes` at most.
template <class T, int kLanes, class Body>
HWY_INLINE void cover(int width, int first_step, Body body) {
    const hn::CappedTag<T, kLanes> d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    if (width >= lanes) return cover_with(d, width, std::min(first_step, lanes), body);
    if constexpr (kLanes > 16 / static_cast<int>(sizeof(T))) {
        return cover<T, 16 / static_cast<int>(sizeof(T))>(width, kLanes, body);
    } else if constexpr (kLanes > 1) {
        if (width > 0) cover<T, 1>(width, 1, body);
    }
}

/// Calls body(d, x) for vectors that cover [0, width) once each, narrower ones at the end: for
/// bodies that change a row in place.
template <class T, int kLanes, class Body>
HWY_INLINE void cover_once(int width, Body body, int x = 0) {
    const hn::CappedTag<T, kLanes> d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (; x + lanes <= width; x += lanes)
        body(d, x);
    if constexpr (kLanes > 4) {
        cover_once<T, 4>(width, body, x);
    } else if constexpr (kLanes > 1) {
        cover_once<T, 1>(width, body, x);
    }
}

/// How far a wide row's second vector stands from its first, so that it and those after it are
/// aligned at `out`: stores across cache lines cost twice. Narrow rows are not worth the overlap.
template <class T, class Out>
HWY_INLINE int aligning_step(const Out* out, int width, std::ptrdiff_t out_stride) {
    const int lanes = static_cast<int>(hn::Lanes(hn::ScalableTag<T>()));
    const auto bytes = static_cast<std::uintptr_t>(lanes) * sizeof(Out);
    const auto beyond = reinterpret_cast<std::uintptr_t>(out) % bytes;
    const bool is_shared = static_cast<std::uintptr_t>(out_stride) * sizeof(Out) % bytes == 0;
    if (beyond == 0 || !is_shared || width < 4 * lanes) return lanes;
    return static_cast<int>((bytes - beyond) / sizeof(Out));
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
