#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/mesh.h"

namespace ink::methods {

/// A face at an edge.
struct EdgeFace {
    std::uint32_t face = 0;
    std::uint32_t opposite = 0;  ///< the place of the face that is not on the edge
    std::int8_t direction = 0;   ///< 1 if the face runs from a to b, -1 from b to a
};

/// An edge between two places, a < b.
struct SoupEdge {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t first = 0;  ///< into SoupEdges::faces_at
    std::uint32_t count = 0;  ///< faces: 1 boundary, 2, or more
};

/// The adjacency of one frame of a model, rebuilt from loose polygons: TechnicalQuake's edge hash.
struct SoupEdges {
    std::vector<std::uint32_t> vertex_of;  ///< per place the vertex that says where it is
    std::vector<scene::Triangle> faces;    ///< over places
    std::vector<SoupEdge> edges;
    std::vector<EdgeFace> faces_at;  ///< grouped by edge

    [[nodiscard]] std::span<const EdgeFace> faces_of(const SoupEdge& edge) const {
        return {faces_at.data() + edge.first, edge.count};
    }
};

/// Loose polygons: what a frame of a model is. Borrowed.
struct Soup {
    std::span<const glm::dvec3> points;  ///< per vertex
    std::span<const scene::Triangle> triangles;
};

/// Welds the vertices that lie within `epsilon` diagonals of their box of each other, drops faces
/// without an area and faces that are there twice, and enters every side of the rest into a hash of
/// edges. Epsilon 0 welds equal positions. O(n) expected; no triangles give no edges.
[[nodiscard]] SoupEdges find_edges(const Soup& soup, double epsilon);

}  // namespace ink::methods
