#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bake/baked_primitives.h"
#include "bake/edge_kinds.h"

namespace ink::bake {

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
