#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raster/depth/depth.h"
#include "scene/scene.h"

namespace ink::raster {

/// How the rasterizer's triangle ids at pixel centres compare with Embree's.
struct IdAgreement {
    std::size_t covered = 0;  ///< by either
    std::size_t near_edge =
        0;  ///< differ, within 1/256 px of an edge of one of the two as projected
    std::size_t near_depth = 0;  ///< else: the two lie less than 4 steps of the depth format apart
    std::size_t in_floats =
        0;  ///< else: no farther apart than the floats of Embree's rays may put their depths
    std::size_t other = 0;  ///< else: a fault
};

/// Whether a place of the image lies within 1/256 px of an edge of a triangle, as projected: of
/// what the plane at distance `near` leaves of it. `p_clip` are its corners as Projection::to_clip
/// gives them. False if nothing is left.
[[nodiscard]] bool is_near_edge(const std::array<glm::dvec3, 3>& p_clip,
                                double near,
                                const glm::dvec2& p_px);

/// Draws `scene` with `depth` and asks Embree along the ray of every pixel centre.
///
/// Distances to edges and between depths are computed here, in double, from the world-space
/// corners. `in_floats` follows from a triangle's shape and place: a plane that is seen at a flat
/// angle, or spanned by a sliver, has depths that floats tell less well. It is 0 on all that the
/// tests compare.
[[nodiscard]] IdAgreement compare_ids(const scene::Scene& scene,
                                      const scene::View& view,
                                      DepthFormat depth);

}  // namespace ink::raster
