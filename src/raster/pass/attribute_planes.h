#pragma once

#include <cstdint>

#include "raster/pass/setup.h"

namespace ink::raster {

/// An integer code over one triangle: its value at a pixel is code_at() >> 16.
///
/// 48.16 fixed point. The coefficients are rounded once, here; from then on everything is exact, so
/// that value(x, y) is the floor of a function that is affine over the integers. Its 5-point
/// Laplacian is 0 before the floor, and each of the two second differences is at most 1 after it:
/// |Laplacian| <= 2, on any plane. The low 32 bits are the 16.16 plane modulo 2^32 of the design,
/// so a kernel may keep those alone for a store that wraps; the high ones tell a saturating u16
/// code of 40000 from -25536.
struct CodePlane {
    std::int64_t at_ref = 0;
    std::int64_t dx =
        0;  ///< at most 2^24 codes a pixel: only slivers, which are limited, have more
    std::int64_t dy = 0;
    std::int64_t lowest = 0;   ///< for thin triangles: floor of the least corner, 48.16
    std::int64_t highest = 0;  ///< and of the greatest
};

inline constexpr int kCodeFractionBits = 16;

/// The code plane through `values` plus `constant`.
[[nodiscard]] CodePlane make_code_plane(const PlaneMaker& maker,
                                        const PerCorner& values,
                                        std::uint32_t constant);

/// A float over one triangle, evaluated in double and rounded to float once.
struct FloatPlane {
    Plane plane;       ///< of the value, or of value times q (perspective)
    float lowest = 0;  ///< of the corners: limits thin triangles, and all quotients (perspective)
    float highest = 0;
};

/// The plane of `values` themselves: affine on the screen.
[[nodiscard]] FloatPlane make_affine_plane(const PlaneMaker& maker, const PerCorner& values);

/// The plane of values times q, to be divided by q again: linear on the surface.
[[nodiscard]] FloatPlane make_perspective_plane(const PlaneMaker& maker,
                                                const PerCorner& values,
                                                const PerCorner& q);

}  // namespace ink::raster
