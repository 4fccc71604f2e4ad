#pragma once

#include <cstdint>
#include <vector>

#include "scene/surface.h"

namespace ink::scene {

/// Which triangles of a surface meet over which edges, and the pieces that hang together so.
///
/// A place is where corners of one object coincide bit for bit (-0 is 0); an edge joins two places.
/// Triangles without an area are in no piece.
struct FaceGraph {
    static constexpr std::uint32_t kNoSolid = 0xffffffffU;

    std::vector<std::uint32_t> corner_at;  ///< the first corner of the surface at each place
    std::vector<std::uint32_t> places;     ///< three a triangle
    /// Three a triangle: the next triangle round the edge from corner i to i + 1, in a ring; the
    /// triangle itself where it has no neighbour.
    std::vector<std::uint32_t> across;
    /// Per triangle, numbered by their first triangles; kNoSolid for one without area.
    std::vector<std::uint32_t> solid_of;
    /// Per solid: every edge has exactly two triangles, both with an area, that run through it
    /// in opposite directions.
    std::vector<bool> is_closed;
    /// Per solid: the same of every edge but those that have a single triangle.
    std::vector<bool> has_rims_only;
    /// Sides of those edges: corner i of triangle t to the next is 3 t + i. Ascending within a
    /// lower place.
    std::vector<std::uint32_t> rim_sides;
};

/// O(n log n). An empty surface gives an empty graph.
[[nodiscard]] FaceGraph make_face_graph(const Surface& surface);

}  // namespace ink::scene
