#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink::bake {

/// Triangles whose code a vertex carries, whichever vertex an engine takes a flat value from.
struct FlatCodes {
    /// 3 a triangle, in the order of the input's; corners may be rotated, so the winding stays.
    std::vector<std::uint32_t> indices;
    /// Per vertex the vertex of the input that it copies: first every one of these itself.
    std::vector<std::uint32_t> source_vertex;
    /// Per vertex; 0 where no triangle needs one.
    std::vector<std::uint64_t> codes;

    /// How many vertices there are more than in the input.
    [[nodiscard]] std::size_t added_count(std::size_t vertex_count) const {
        return source_vertex.size() - vertex_count;
    }
};

/// One code per triangle made one per vertex: of each triangle the first and the last vertex carry
/// its code, so that the file serves whether a flat value is that of the first vertex or the last.
///
/// Only two corners of a triangle need the code, so a vertex is split only where it needs two codes
/// and no other corner can carry them. Which corners go without is chosen greedily, those first
/// that leave the most others a choice. `indices` has 3 a triangle below `vertex_count`, `codes`
/// one a triangle. No triangles: the vertices as they are, code 0. Deterministic; O(n log d) with
/// d the triangles at one vertex. Throws core::Error for an index that is out of range, and for
/// more than 2^32 - 2 vertices.
[[nodiscard]] FlatCodes flat_codes(std::span<const std::uint32_t> indices,
                                   std::size_t vertex_count,
                                   std::span<const std::uint64_t> codes);

}  // namespace ink::bake
