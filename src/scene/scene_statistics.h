#pragma once

#include <array>
#include <cstddef>

#include "scene/camera.h"
#include "scene/crease.h"
#include "scene/prepared_scene.h"
#include "scene/scene.h"
#include "scene/topology.h"

namespace ink::scene {

/// Some edges: how many, and how long they are together.
struct EdgeTally {
    std::size_t count = 0;
    double length_world = 0;
};

inline constexpr int kDeviationBins = 18;  ///< of 10 degrees each

/// Surfaces that lie so near to each other that depth may not part them.
struct NearSheets {
    std::size_t pairs =
        0;  ///< parallel faces of two components, one before the other; see scene_statistics.cpp
    double least_gap_share = 0;  ///< their least distance over the scene's radius; 0: in one plane
};

/// What a scene has and what it has not, whatever the view: from this a method may plan.
///
/// Edges are those of the welded scene. Each with two faces is a crease, smooth, or flat; the rest
/// are boundaries and non-manifold ones. Seams and inside-out edges are counted among those, too.
struct SceneStatistics {
    double crease_rad = 0;  ///< least dihedral deviation of a crease

    std::size_t triangles = 0;  ///< degenerate and repeated ones left out
    std::size_t vertices = 0;   ///< places
    std::size_t objects = 0;
    std::size_t materials = 0;
    Sphere bounds;

    EdgeTally creases;      ///< two faces, bent by crease_rad or more
    EdgeTally smooth;       ///< two faces, bent by kFlat_rad .. crease_rad: a curved surface
    EdgeTally flat;         ///< two faces in one plane
    EdgeTally seams;        ///< smooth or flat, between two objects
    EdgeTally boundary;     ///< one face
    EdgeTally nonmanifold;  ///< three faces or more
    EdgeTally inside_out;   ///< smooth, but its faces run through it in the same direction
    std::array<std::size_t, kDeviationBins>
        deviations{};  ///< creases and smooth edges by dihedral deviation
    CreaseProposal crease_proposal;
    double largest_smooth_rad = 0;  ///< 0 without any
    double least_crease_rad = 0;    ///< 0 without any

    std::size_t components = 0;             ///< parts that share no edge
    std::size_t watertight_components = 0;  ///< closed, consistently oriented, turned outwards
    std::size_t convex_components = 0;  ///< of these, such as cannot hide a part of their own front
    std::size_t loose_triangles = 0;    ///< no neighbour at any edge
    double thin_share = 0;  ///< of the length of all lines: those of components that are thinner,
                            ///< as area over length of lines, than kThinShare of the radius
    std::size_t cracked_corners = 0;  ///< corners of boundaries with another one within kCrackShare
    std::size_t overlapping_components = 0;  ///< pairs of components that might pierce each other
    double extent_ratio = 1;                 ///< largest to smallest object; 1 for a single one
    NearSheets near_sheets;

    [[nodiscard]] bool has_creases() const { return creases.count + nonmanifold.count > 0; }
    [[nodiscard]] bool is_curved() const { return smooth.count > 0; }
    /// Share of the edges that are smooth, 0..1.
    [[nodiscard]] double smooth_share() const {
        const std::size_t all =
            creases.count + smooth.count + flat.count + boundary.count + nonmanifold.count;
        return all == 0 ? 0 : static_cast<double>(smooth.count) / static_cast<double>(all);
    }
    [[nodiscard]] bool is_watertight() const {
        return components > 0 && watertight_components == components;
    }
    [[nodiscard]] bool may_cross() const { return overlapping_components > 0; }
    /// Whether any part of the scene can stand before another one, or before itself.
    [[nodiscard]] bool may_hide() const { return components > 1 || convex_components < components; }
    /// Share of the triangles without a neighbour, 0..1.
    [[nodiscard]] double loose_share() const {
        return triangles == 0
                   ? 0
                   : static_cast<double>(loose_triangles) / static_cast<double>(triangles);
    }
};

/// A bar as thin has half a pixel where its scene fills the height of 720.
inline constexpr double kThinShare = 1.0 / 720;

/// How near two corners of boundaries must lie to be the two sides of a crack: a share of the
/// diagonal of the box round all such corners.
inline constexpr double kCrackShare = 1e-4;

/// The scene statistics of `scene`, welded at the same places. O(n log n). An empty scene gives
/// zeros.
[[nodiscard]] SceneStatistics make_scene_statistics(const PreparedScene& scene, double crease_rad);

}  // namespace ink::scene
