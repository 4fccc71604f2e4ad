#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bake/baked_primitives.h"
#include "methods/surface_codes/smooth_mesh.h"
#include "scene/prepared_scene.h"

namespace ink::bake {

/// What an edge is to EXT_mesh_primitive_edge_visibility.
enum class EdgeKind : std::uint8_t {
    hidden,      ///< between faces of one plane
    silhouette,  ///< a line where one of its faces is seen from its front, the other from its back
    hard,        ///< a crease, a boundary, a seam, or an edge of more than two faces
};

/// An edge of the welded scene.
struct KnownEdge {
    EdgeKind kind = EdgeKind::hidden;
    /// Of a silhouette edge its two faces, as triangles of the scene (global indices).
    std::array<std::uint32_t, 2> triangles{};
    /// Whether these run through the edge in the same direction: one has its back outside.
    bool is_inconsistent = false;
};

/// The edges of a scene's triangles.
struct SceneEdges {
    static constexpr std::uint32_t kNone = 0xffffffffU;

    std::vector<KnownEdge> edges;
    /// Per triangle of the scene, by global index, the edges from its corner i to the next as its
    /// file has them; kNone for one without length, or of no face.
    std::vector<std::array<std::uint32_t, 3>> of_triangle;
};

/// Sorts the edges of a smooth mesh, which is the scene's.
///
/// Hard are those that no surface goes on over more smoothly than a crease. One that lies on
/// others without having both ends in common (a T-junction) is none of these where they cover it.
/// Of two that then lie on each other, the longer is hidden. Triangles that repeat a face, or have
/// no area, have the edges of the faces that they lie on. O(n) beside welding.
[[nodiscard]] SceneEdges find_edges(const scene::PreparedScene& scene,
                                    const methods::SmoothMesh& mesh);

using import::EdgeVisibility;
using enum import::EdgeVisibility;

/// One number per edge of the triangles, 3 a triangle: the first of a hard edge is 2, its repeats
/// 3, the first of a silhouette edge 1, its repeats 0. `triangles` holds numbers of `edges`, or
/// SceneEdges::kNone.
[[nodiscard]] std::vector<std::uint8_t> edge_visibility(
    std::span<const std::array<std::uint32_t, 3>> triangles, std::span<const KnownEdge> edges);

/// Two bits a number, low bits first; what is left of the last byte is 0.
[[nodiscard]] std::vector<std::byte> packed_visibility(std::span<const std::uint8_t> values);

/// What was written.
struct EdgeCounts {
    std::size_t hard = 0;
    std::size_t silhouettes = 0;
};

/// Gives the primitives the extension, one that has any edge to draw; each primitive draws its own
/// edges, so that it is whole where others are left out. A pair of outward normals for each
/// silhouette edge, in object space, is as floats. Throws core::Error that names the primitive if
/// it has the extension already, unless `is_again`: then it is replaced.
EdgeCounts add_edges(GltfEdit& edit,
                     const std::vector<BakedPrimitive>& primitives,
                     const SceneEdges& edges,
                     bool is_again);

/// Whether a primitive has the extension in the file as it was.
[[nodiscard]] bool has_edges(const BakedPrimitive& primitive);

}  // namespace ink::bake
