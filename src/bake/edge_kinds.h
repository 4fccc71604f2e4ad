#pragma once

#include <array>
#include <cstdint>
#include <vector>

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

}  // namespace ink::bake
