#include "score/drawn_matcher.h"

namespace ink::score {

DrawnMatcher::DrawnMatcher(const PixelList& drawn, const Disk& disk, int width_px)
    : is_empty_(drawn.is_empty()), matcher_(width_px, drawn.height_px(), disk) {
    matcher_.set_right(drawn);
}

std::int64_t DrawnMatcher::match(const PixelList& truth) {
    if (truth.is_empty() || is_empty_) return 0;
    matcher_.set_left(truth);
    return matcher_.match();
}

}  // namespace ink::score
