#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "raster/pass/pass.h"

namespace ink::raster {

/// The planes at which a triangle is cut: near, and the left, right, upper and lower end of a band.
inline constexpr int kClipPlanes = 5;

/// How far inside plane 0 .. kClipPlanes - 1 a point (x, y, w) lies; negative outside. The band's
/// ends stand `band_px` on either side of the image's origin. In units of w, so only the sign
/// compares.
[[nodiscard]] double inside_by(int plane, const glm::dvec3& p_clip, double near, double band_px);

/// A corner in clip space with what is interpolated from it.
struct ClipVertex {
    glm::dvec3 p_clip{0};                     ///< (x, y, w)
    std::array<double, kMaxPlanes> values{};  ///< the first K are used
};

/// A convex polygon: a triangle cut by at most five planes.
struct ClipPolygon {
    static constexpr int kMaxCorners = 8;
    std::array<ClipVertex, kMaxCorners> corners;
    int count = 0;  ///< 0 (nothing left) or 3..8
};

/// What of a triangle lies inside the near plane (w >= near) and the guard band, in the order of
/// its corners. Values run linearly in clip space, on the surface, whatever the pass does
/// afterwards.
///
/// Where an edge meets a plane is computed from its two ends in an order that depends on their
/// positions only. So two triangles that share an edge cut it at bit-identical points, whichever
/// way each runs along it, and stay watertight. Corners must be finite (outcode without
/// kNotANumber). Sutherland and Hodgman 1974, "Reentrant polygon clipping".
[[nodiscard]] ClipPolygon clip_triangle(const std::array<ClipVertex, 3>& triangle, double near);

}  // namespace ink::raster
