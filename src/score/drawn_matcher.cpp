#include "score/drawn_matcher.h"

#include "score/reach.h"

namespace ink::score {

DrawnMatcher::DrawnMatcher(const PixelList& drawn, const Disk& disk, int width_px)
    : is_empty_(drawn.is_empty()),
      truth_(width_px, drawn.height_px()),
      matcher_(width_px, drawn.height_px(), disk) {
    matcher_.set_right(mask_of(drawn, width_px).words());
}

std::int64_t DrawnMatcher::match(const PixelList& truth) {
    if (truth.is_empty() || is_empty_) return 0;
    truth.visit([&](int x, int y) { truth_.set(x, y); });
    matcher_.set_left(truth_.words());
    truth.visit([&](int x, int y) { truth_.clear(x, y); });
    return matcher_.match();
}

}  // namespace ink::score
