#include "score/matching.h"

namespace ink::score {

MatchCounts match_pixels(const PixelList& left, const PixelList& right, const Disk& disk) {
    if (left.is_empty() || right.is_empty()) return {};
    BitMatcher matcher(left.width_px(), left.height_px(), disk);
    matcher.set_left(left);
    matcher.set_right(right);
    return {.k = matcher.match(),
            .left_reached = matcher.left_reached(),
            .right_reached = matcher.right_reached()};
}

DrawnMatcher::DrawnMatcher(const PixelList& drawn, const Disk& disk)
    : is_empty_(drawn.is_empty()), matcher_(drawn.width_px(), drawn.height_px(), disk) {
    matcher_.set_right(drawn);
}

std::int64_t DrawnMatcher::match(const PixelList& truth) {
    if (truth.is_empty() || is_empty_) return 0;
    matcher_.set_left(truth);
    return matcher_.match();
}

}  // namespace ink::score
