#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "scene/topology.h"
#include "scene/viewpoint.h"

namespace ink::scene {

// Vertices come as floats, so each stands for any place within half a unit in the last place of it
// (Topology::rounding_world). What follows says what holds wherever in there they are: the same
// thing, turned and rounded again, then has the same answers.

/// Half a unit in the last place of the largest coordinate.
[[nodiscard]] double half_ulp(const glm::vec3& p);

/// How far rounding (Topology::rounding_world) may have moved a vertex that the view has in its
/// frame, before what hides it, the most of all. 0 where there is none. O(vertices).
[[nodiscard]] double most_rounding_px(const Topology& topology, const View& view);

/// A point and how far from it the meant one may lie, world units.
struct RoundedPoint {
    glm::dvec3 p{0};
    double rounding = 0;
};

/// The vertex of a welded scene.
[[nodiscard]] inline RoundedPoint rounded_point(const Topology& topology, std::uint32_t vertex) {
    return {topology.p_world[vertex], topology.rounding_world[vertex]};
}

/// By how much the rounding of the four points may change orient3d_value of them: to first order
/// each moves it by the area of the triangle of the other three.
[[nodiscard]] double orient3d_doubt(const RoundedPoint& a,
                                    const RoundedPoint& b,
                                    const RoundedPoint& c,
                                    const RoundedPoint& d);

/// The sign of orient3d, or 0 where the rounding of the points leaves it open.
[[nodiscard]] int sure_orient3d(const RoundedPoint& a,
                                const RoundedPoint& b,
                                const RoundedPoint& c,
                                const RoundedPoint& d);

/// The side of a face on which the eye lies, as facing() has it, or 0 where the rounding of the
/// corners leaves it open.
[[nodiscard]] int sure_facing(const RoundedPoint& a,
                              const RoundedPoint& b,
                              const RoundedPoint& c,
                              const Viewpoint& eye);

/// By how much rounding may turn a triangle about its side a, b, radians; `c` is its third corner.
[[nodiscard]] double turning_doubt_rad(const RoundedPoint& a,
                                       const RoundedPoint& b,
                                       const RoundedPoint& c);

/// Whether faces that deviate from flat by this much crease: by `crease_rad` or more, or perhaps so
/// as far as rounding can tell, which may turn both by `doubt_rad` in all. So faces that were made
/// to bend by just that angle crease in every pose. Where the doubt is above a thousandth of a
/// radian (slivers) the deviation alone decides.
[[nodiscard]] bool is_crease(double deviation_rad, double doubt_rad, double crease_rad);

/// Whether two faces at an edge crease: they deviate from flat by `crease_rad` or more, as
/// far as the rounding of their vertices can tell.
[[nodiscard]] bool is_crease(const Topology& topology,
                             const Edge& edge,
                             std::uint32_t face0,
                             std::uint32_t face1,
                             double crease_rad);

}  // namespace ink::scene
