#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/mesh.h"

namespace ink::raster {

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
