#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>

#include "scene/topology.h"

namespace ink::truth {

/// How far a point is from the nearest point of a closed triangle, world units.
///
/// By the region in which its projection falls (Ericson 2005, "Real-Time Collision Detection",
/// section 5.1.5), so that it needs no normal and holds for needles too.
[[nodiscard]] double distance_to_triangle(const glm::dvec3& p,
                                          const std::array<glm::dvec3, 3>& corners);

/// The segment in which two triangles cross, in the interior of both but for its ends.
struct Crossing {
    std::uint32_t face0 = 0;  ///< into Topology::faces, face0 < face1
    std::uint32_t face1 = 0;
    glm::dvec3 begin_world{0};
    glm::dvec3 end_world{0};
    /// Both faces end within this of all of the crossing, and go on from each other (world units;
    /// see slit_crossings.h); infinity: they do not.
    double slit_world = std::numeric_limits<double>::infinity();
    double error = 0;  ///< world units: each end lies within this of where the two as given have it
};

/// A stretch of a mesh edge that lies in a triangle it is no edge of: inside it, or along its
/// border.
struct Contact {
    std::uint32_t edge = 0;
    double t_begin = 0;  ///< the stretch is a + t (b - a), t_begin <= t <= t_end
    double t_end = 1;
    std::uint32_t face = 0;
};

/// Two triangles in one plane that have more than points in common.
struct CoplanarPair {
    std::uint32_t face = 0;
    std::uint32_t lower_face = 0;  ///< the one that is seen where both are: lower_face < face
};

/// What two triangles of a welded scene have in common besides shared vertices and edges.
struct Meeting {
    std::optional<Crossing> crossing;
    std::array<Contact, 6> contacts;
    std::size_t contact_count = 0;
    bool is_coplanar = false;  ///< and they have more than points in common
};

/// Decides what two triangles have in common, wherever in the rounding of its coordinates each
/// vertex was meant to be: a sign that rounding leaves open counts as 0
/// (scene/precision/rounding.h). So triangles that were made to touch do, in every pose, and
/// neither cross nor gape by a hair.
///
/// Planes that cross: each triangle meets the line in which they do in a stretch whose ends lie on
/// two of its edges (or at its vertices); signs of orient3d say which edges, and the sign for one
/// edge of either triangle says whose end comes first along the line (Guigue and Devillers 2003,
/// "Fast and robust triangle-triangle overlap test using orientation predicates", section 3). What
/// the stretches share is a crossing if its inside lies in the interior of both triangles, and
/// contacts of each edge that it lies on. So a single common point is nothing, nor is an edge that
/// both share. Only the coordinates of the ends are rounded. One plane: every edge that is not
/// shared is clipped to the other triangle; there stretches below 1e-12 of the edge count as
/// points.
///
/// Degenerate triangles are not allowed (weld drops them). Same result if the faces are swapped.
[[nodiscard]] Meeting meet(const scene::Topology& topology, std::uint32_t f, std::uint32_t g);

}  // namespace ink::truth
