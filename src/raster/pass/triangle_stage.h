#pragma once

#include <cstdint>
#include <vector>

#include "raster/pass/pass.h"
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

/// The triangles made from one run of submitted ones, in order; a clipped one makes several.
struct Batch {
    std::vector<SetupTriangle> triangles;
    /// K per triangle; at most one of the two is filled: what the format does not store is not
    /// made.
    std::vector<CodePlane> code_planes;
    std::vector<FloatPlane> float_planes;
    std::uint64_t no_sample = 0;  ///< submitted ones in the image that have no pixel centre
};

/// Submitted triangles per batch: a batch of large triangles stays in the second-level cache.
inline constexpr std::size_t kBatchTriangles = 4096;

/// Whether a format's planes are CodePlanes (integer store and affine), else FloatPlanes.
[[nodiscard]] inline bool has_code_planes(const PassFormat& format) {
    return format.store != Store::f32 && format.interpolation == Interpolation::affine;
}

/// Clips and sets up the whole input: batch i holds triangles i * kBatchTriangles onwards.
[[nodiscard]] std::vector<Batch> set_up_batches(const PassFormat& format,
                                                const PassInput& input,
                                                const PixelRect& image,
                                                int threads);

/// Clips and sets up a short input after what `batch` holds already, on this thread.
void set_up_more(const PassFormat& format,
                 const PassInput& input,
                 const PixelRect& image,
                 Batch& batch);

}  // namespace ink::raster
