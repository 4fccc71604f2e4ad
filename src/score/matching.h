#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "score/pixel_list.h"

namespace ink::score {

/// Which pixels of two sets may be matched: a bipartite graph.
///
/// Vertices 0..n_left-1 are the pixels of the left list, n_left..n_left+n_right-1 those of the
/// right one. The neighbours of vertex v are neighbours[begin[v]] .. neighbours[begin[v + 1] - 1].
struct CandidateGraph {
    std::size_t n_left = 0;
    std::size_t n_right = 0;
    std::vector<std::uint32_t> begin = {0};
    std::vector<std::uint32_t> neighbours;

    [[nodiscard]] std::uint32_t degree(std::size_t v) const { return begin[v + 1] - begin[v]; }
};

/// The graph of all pairs within `disk`.
///
/// Throws core::Error if there are more than 250 million pairs (2 GB): only a wide tolerance on
/// densely filled images comes there.
[[nodiscard]] CandidateGraph candidate_graph(const PixelList& left,
                                             const PixelList& right,
                                             const Disk& disk);

/// The most pairs that can be chosen so that no vertex is in two of them.
///
/// Starts as Karp and Sipser do (vertices with one free neighbour first, which is never wrong),
/// then grows by breadth-first augmenting paths from the unmatched left vertices (Berge), so the
/// result is exact. Fastest when the left side is the smaller one.
///
/// Source: Karp and Sipser, "Maximum matchings in sparse random graphs", FOCS 1981.
[[nodiscard]] std::int64_t maximum_matching(const CandidateGraph& graph);

/// What a maximum matching of two sets says; every number is unique.
struct MatchCounts {
    std::int64_t k = 0;             ///< pairs
    std::int64_t left_reached = 0;  ///< left pixels with a right pixel in reach
    std::int64_t right_reached = 0;
};

/// Matches two sets of pixels one to one within `disk`: by a BitMatcher if it takes the disk, else
/// by a candidate_graph(). Symmetric: swapped sets give the same numbers.
[[nodiscard]] MatchCounts match_pixels(const PixelList& left,
                                       const PixelList& right,
                                       const Disk& disk);

/// match_pixels().k alone, which takes less.
[[nodiscard]] std::int64_t count_pairs(const PixelList& left,
                                       const PixelList& right,
                                       const Disk& disk);

}  // namespace ink::score
