#pragma once

#include <cstdint>

#include "score/bit_matcher.h"
#include "score/pixel_list.h"

namespace ink::score {

/// Matches the drawn pixels of one image with one set of true pixels after the other: classes,
/// bins, kinds. What belongs to the image alone is made once.
class DrawnMatcher {
  public:
    DrawnMatcher(const PixelList& drawn, const Disk& disk, int width_px);

    /// The size of a maximum one-to-one matching with `truth`, of the image's size:
    /// match_pixels().k.
    [[nodiscard]] std::int64_t match(const PixelList& truth);

  private:
    bool is_empty_;
    BitMatcher matcher_;
};

}  // namespace ink::score
