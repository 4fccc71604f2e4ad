#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/mesh.h"

namespace ink::methods {

/// How the edges of a list of triangles are found.
enum class EdgeBuilder {
    all_pairs,  ///< each side of a triangle compared with every later one
    temp_list,  ///< CoRgi's: each side looked up among those whose mate has not come yet
    hash,       ///< the same, those kept in a hash table
};

/// The face that an edge does not have.
inline constexpr std::uint32_t kNoFace = 0xffffffffU;

/// An edge between two vertices, a < b, and its two faces in their order; of a boundary edge the
/// second is kNoFace.
struct ListedEdge {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::array<std::uint32_t, 2> faces{kNoFace, kNoFace};

    [[nodiscard]] bool is_boundary() const { return faces[1] == kNoFace; }
    friend bool operator==(const ListedEdge&, const ListedEdge&) = default;
};

/// What the inner loop did.
struct BuildCounts {
    std::uint64_t lookups = 0;      ///< sides of triangles: three a triangle
    std::uint64_t comparisons = 0;  ///< of one side with another
    std::uint64_t longest = 0;      ///< the most sides that were waiting for their mates at a time

    [[nodiscard]] double comparisons_per_lookup() const {
        return lookups == 0 ? 0 : static_cast<double>(comparisons) / static_cast<double>(lookups);
    }
};

struct EdgeListing {
    std::vector<ListedEdge> edges;  ///< in no order that matters
    BuildCounts counts;
};

/// The edges of `triangles`, whose equal corners have equal numbers.
///
/// A side's mate is the next one, in the order of triangles, between the same two vertices that has
/// none yet, whichever way either runs. So every builder gives the same edges, of any triangles: on
/// a closed 2-manifold each edge with its two faces; where three meet, the first two are an edge
/// and the third is a boundary one; of four, two and two.
///
/// With n sides all_pairs makes n (n-1) / 2 comparisons and never stops early; temp_list goes
/// through its list from the latest entry back until it finds the mate, which then leaves the list;
/// hash compares what it meets on its way to a slot. No triangle gives no edge.
[[nodiscard]] EdgeListing list_edges(std::span<const scene::Triangle> triangles,
                                     EdgeBuilder builder);

}  // namespace ink::methods
