#pragma once

#include <cstdint>

#include "score/bit_matcher.h"
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

/// Matches the drawn pixels of one image with one set of true pixels after the other: classes,
/// bins, kinds. What belongs to the image alone is made once.
class DrawnMatcher {
  public:
    DrawnMatcher(const PixelList& drawn, const Disk& disk);

    /// The size of a maximum one-to-one matching with `truth`, of the image's size:
    /// match_pixels().k.
    [[nodiscard]] std::int64_t match(const PixelList& truth);

  private:
    bool is_empty_;
    BitMatcher matcher_;
};

}  // namespace ink::score
