#pragma once

#include <cstdint>

#include "score/pixel_list.h"

namespace ink::score {

/// What a maximum matching of two sets says; every number is unique.
struct MatchCounts {
    std::int64_t k = 0;             ///< pairs
    std::int64_t left_reached = 0;  ///< left pixels with a right pixel in reach
    std::int64_t right_reached = 0;
};

/// Matches two sets of pixels one to one within `disk`, which is one that a BitMatcher takes.
/// Symmetric: swapped sets give the same numbers.
[[nodiscard]] MatchCounts match_pixels(const PixelList& left,
                                       const PixelList& right,
                                       const Disk& disk);

/// match_pixels().k alone, which takes less.
[[nodiscard]] std::int64_t count_pairs(const PixelList& left,
                                       const PixelList& right,
                                       const Disk& disk);

}  // namespace ink::score
