#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "raster/pass/pass.h"
#include "scene/mesh.h"

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

/// Corners of a surface in clip space (x, y, w), with their normals.
struct CutVertices {
    std::vector<glm::dvec3> p_clip;
    std::vector<glm::vec3> n;
    bool is_parallel = false;  ///< of a parallel camera: 1/w, not w, is linear in the world
};

/// Triangles and the side that each shows.
struct CutTriangles {
    std::vector<scene::Triangle> triangles;
    std::vector<std::int8_t> facing;
    std::vector<std::uint32_t> source;  ///< which of the given triangles each is a piece of
};

/// How far outside the image corners may lie, in px from its top left: well within what the
/// rasterizer takes uncut.
inline constexpr double kCutBand_px = 1 << 19;

/// Whether a corner lies beyond the near plane or outside the band.
[[nodiscard]] inline bool needs_cut(const glm::dvec3& p_clip, double near) {
    const double reach = kCutBand_px * p_clip.z;
    return p_clip.z < near || p_clip.x > reach || p_clip.x < -reach || p_clip.y > reach ||
           p_clip.y < -reach;
}

/// Cuts triangles at the near plane and at the band; corners that a cut needs are appended to
/// `vertices`, their normals interpolated and not renormalised.
///
/// This is done before anything is computed at vertices, because what methods compute there (1/w
/// above all) is not linear in clip space, which is all that a rasterizer could assume. Both
/// neighbours of an edge get the same bits for a cut of it. What is left of `out` from before is
/// dropped.
void cut_triangles(std::span<const scene::Triangle> triangles,
                   std::span<const std::int8_t> facing,
                   double near,
                   CutVertices& vertices,
                   CutTriangles& out);

}  // namespace ink::raster
