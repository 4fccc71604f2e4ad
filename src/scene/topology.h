#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace ink::scene {

/// A triangle of the welded scene.
struct Face {
    std::array<std::uint32_t, 3> vertices{};  ///< into Topology::p_world, counter-clockwise
    std::array<std::uint32_t, 3> edges{};     ///< edges[i] joins vertices[i] and vertices[(i+1)%3]
    std::uint32_t object = 0;                 ///< instance index
    std::uint32_t material = 0;               ///< unique over the scene only within one file
    std::uint32_t triangle = 0;               ///< global triangle index (see triangle_count)
    std::uint8_t marked_sides = 0;            ///< as Mesh::marked_sides; bit i is edges[i]
};

/// A triangle that became no face.
struct LostTriangle {
    static constexpr std::uint32_t kNoFace = 0xffffffffU;

    std::uint32_t triangle = 0;               ///< global triangle index
    std::array<std::uint32_t, 3> vertices{};  ///< where its corners came to be, as in Face
    /// The face that has the same corners, if nothing moved them: equally deep, either may be the
    /// one that is seen.
    std::uint32_t face = kNoFace;
};

/// An undirected edge of the welded scene, a < b.
struct Edge {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t first_face = 0;  ///< its faces are Topology::edge_faces[first_face, + face_count)
    std::uint32_t face_count = 0;  ///< 1 boundary, 2 manifold, more non-manifold
    double deviation_rad = 0;      ///< of the two of a manifold edge, as the function says
};

/// What welding met; nothing of it is repaired.
struct TopologyCounts {
    std::size_t triangles = 0;   ///< in the scene
    std::size_t degenerate = 0;  ///< dropped: two corners welded together, or exactly collinear
    std::size_t duplicate = 0;   ///< dropped: the same three vertices again, in any order
    std::size_t collapsed = 0;   ///< of the degenerate ones those that only epsilon made so
    std::size_t joined_vertices = 0;  ///< places that epsilon moved onto another one
};

/// The scene as one welded polyhedron in world space: what truth and adjacency methods work on.
struct Topology {
    std::vector<glm::dvec3> p_world;
    /// Per vertex: how far it may lie from the place that was meant, because its object's
    /// coordinates are floats. Half a unit in the last place of the largest of them, carried
    /// through the object's transform; of joined vertices the most.
    std::vector<double> rounding_world;
    /// Per object: how far the few decimal digits that its file has may have moved a vertex
    /// (precision/written_digits.h); 0 where floats have more to say, or it is more than 1/64 px of
    /// an image on which the scene is 256 px wide. Empty where it is 0 for all.
    std::vector<double> written_rounding_world;
    std::vector<Face> faces;
    std::vector<Edge> edges;
    std::vector<std::uint32_t> edge_faces;  ///< face indices, grouped by edge, ascending in each
    std::vector<LostTriangle> lost;         ///< by triangle
    TopologyCounts counts;

    [[nodiscard]] std::span<const std::uint32_t> faces_of(const Edge& edge) const {
        return {edge_faces.data() + edge.first_face, edge.face_count};
    }
    /// How far rounding may have moved any corner of a face, world units.
    [[nodiscard]] double rounding_of(std::uint32_t face) const {
        const auto& [a, b, c] = faces[face].vertices;
        return std::max({rounding_world[a], rounding_world[b], rounding_world[c]});
    }
    /// Orthogonal to a face, towards where it runs counter-clockwise; of twice its area's length.
    [[nodiscard]] glm::dvec3 area_vector(std::uint32_t face) const {
        const auto& [a, b, c] = faces[face].vertices;
        return glm::cross(p_world[b] - p_world[a], p_world[c] - p_world[a]);
    }
};

/// How near vertices must lie to be one.
struct WeldOptions {
    /// Share of the diagonal of the box round each part (instance), 0..1. 0 welds what is
    /// bit-identical; more moves vertices, which closes cracks and may collapse small triangles.
    double epsilon = 0;
};

/// Welds vertices at bit-identical world positions over the whole scene (-0 equals 0) and builds
/// the edges. Importers split meshes by material and by seam, so per-mesh indices say nothing.
///
/// With an epsilon, vertices of one part that lie within that share of the part's own diagonal
/// become one, and so do those that are joined over others; the group moves to the one that is
/// first by x, then y, then z. Neither the order of triangles nor that of instances matters for
/// which vertices are joined and where they go. Parts differ in size by orders of magnitude, so a
/// distance that closes one would flatten another.
///
/// O(n) expected; O(n log n) with an epsilon. An empty scene gives an empty topology.
[[nodiscard]] Topology weld(const Scene& scene, const WeldOptions& options = {});

/// Whether the face goes round its edge from `a` to `b`.
[[nodiscard]] bool runs_forward(const Face& face, const Edge& edge);

/// Whether the two faces of an edge run through it in opposite directions: neither has its back
/// where the other has its front.
[[nodiscard]] bool is_consistent(const Topology& topology, const Edge& edge);

/// Which corner of a face lies at one of its vertices, and which of its edges one of them is.
[[nodiscard]] inline std::uint32_t corner_at(const Face& face, std::uint32_t vertex) {
    return face.vertices[0] == vertex ? 0U : face.vertices[1] == vertex ? 1U : 2U;
}
[[nodiscard]] inline std::uint32_t side_at(const Face& face, std::uint32_t edge) {
    return face.edges[0] == edge ? 0U : face.edges[1] == edge ? 1U : 2U;
}

/// The corner of a face that one of its edges leaves out.
[[nodiscard]] std::uint32_t opposite_vertex(const Face& face, const Edge& edge);
/// Which of a face's edges leaves out one of its vertices.
[[nodiscard]] inline std::uint32_t side_opposite(const Face& face, std::uint32_t vertex) {
    return (corner_at(face, vertex) + 1) % 3;
}

/// The angle by which the two faces at an edge deviate from flat, 0..pi, whichever way each is
/// oriented: pi minus the angle between the directions from the edge into the two faces.
[[nodiscard]] double deviation_rad(const Topology& topology,
                                   const Edge& edge,
                                   std::uint32_t face0,
                                   std::uint32_t face1);
/// The same of two faces given by the ends of the edge, as either has it, and their third corners.
[[nodiscard]] double deviation_rad(const std::array<glm::dvec3, 3>& one,
                                   const std::array<glm::dvec3, 3>& other);

}  // namespace ink::scene
