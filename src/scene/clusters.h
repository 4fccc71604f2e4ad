#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/camera.h"
#include "scene/holes/holes.h"
#include "scene/surface.h"

namespace ink::scene {

/// A handful of neighbouring triangles of one instance, small enough for vector registers.
struct Cluster {
    std::uint32_t first_vertex = 0;    ///< into Clusters::vertices
    std::uint32_t first_triangle = 0;  ///< into Clusters::triangles and triangle_ids
    std::uint16_t vertex_count = 0;    ///< 1 .. kMaxClusterVertices
    std::uint16_t triangle_count = 0;  ///< 1 .. kMaxClusterTriangles
    std::uint32_t solid = 0;           ///< into Clusters::solids
    Sphere bounds;                     ///< of its vertices, world space
    /// Cone of its faces' normals: each is within asin(cone_sine) of the axis. cone_sine >= 1: no
    /// cone, its normals point all ways.
    glm::dvec3 cone_axis{0};
    double cone_sine = 1;
    /// How far at most the centre of `bounds` stands out in front of a face's plane; below 0 if it
    /// lies behind them all. At most the radius.
    double center_height = 0;
};

/// A connected piece of the surface, joined over welded edges.
struct Solid {
    Sphere bounds;
    std::uint32_t object = 0;  ///< instance index
    /// Every edge has two faces that run through it in opposite directions; of the topology alone.
    bool is_closed = false;
    /// Closed, consistently oriented and turned outwards (its signed volume is positive): seen from
    /// outside, a face turned away always lies behind one that is not.
    bool is_watertight = false;
    std::uint32_t first_hole = 0;  ///< into Clusters::holes
    std::uint32_t hole_count = 0;  ///< 0 if it is closed, or cannot be covered
    /// It would be watertight with its holes covered, as refresh_holes says: seen from outside, a
    /// face turned away lies behind one that is not, but for sight lines through a hole.
    bool is_watertight_covered = false;
};

inline constexpr std::size_t kMaxClusterVertices = 64;
inline constexpr std::size_t kMaxClusterTriangles = 124;

/// The surface cut into clusters, each triangle in exactly one of them; made once per topology.
///
/// Degenerate triangles are left out: they cover nothing. Neighbours in `clusters` are near each
/// other in space, and every cluster lies in one solid.
struct Clusters {
    std::vector<Cluster> clusters;
    std::vector<Solid> solids;
    std::vector<std::uint32_t> vertices;  ///< corner of the surface per vertex of a cluster
    /// Per vertex, the surface's first corner at the same place when the clusters were made.
    std::vector<std::uint32_t> places;
    std::vector<std::array<std::uint8_t, 3>> triangles;  ///< vertices within the cluster
    std::vector<std::uint32_t> triangle_ids;             ///< global index of each
    std::vector<std::uint32_t> left_out;  ///< global indices of the degenerate triangles
    std::vector<Hole> holes;              ///< those of one solid in a row
    std::vector<std::uint32_t> rims;      ///< corners of the surface, hole by hole, in order
};

/// Cuts `surface` into clusters. O(n log n). An empty surface has none.
[[nodiscard]] Clusters make_clusters(const Surface& surface);

/// Bounds, cones, seals and holes anew after the surface's corners moved; the same triangles as
/// before.
///
/// A solid that came apart at its seams, or a face of which lost its area, is not watertight. If a
/// triangle that was degenerate now has an area, the surface is cut anew.
void refresh(const Surface& moved, Clusters& clusters);

/// Whether the eye certainly sees the back of every face of the cluster, with room for rounding.
[[nodiscard]] bool is_turned_away(const Cluster& cluster, const Viewpoint& eye);

}  // namespace ink::scene
