#include "score/drawn_matcher.h"

#include "score/matching.h"
#include "score/reach.h"

namespace ink::score {

DrawnMatcher::DrawnMatcher(const PixelList& drawn, const Disk& disk, int width_px)
    : drawn_(drawn), disk_(disk), truth_(width_px, drawn.height_px()) {
    if (!BitMatcher::takes(disk)) return;
    matcher_.emplace(width_px, drawn.height_px(), disk);
    matcher_->set_right(mask_of(drawn, width_px).words());
}

std::int64_t DrawnMatcher::match(const PixelList& truth) {
    if (truth.is_empty() || drawn_.is_empty()) return 0;
    if (!matcher_) return count_pairs(drawn_, truth, disk_);
    const auto for_each = [&](auto visit) {
        for (int y = 0; y < truth.height_px(); ++y) {
            for (std::size_t i = truth.row_begin(y); i < truth.row_begin(y + 1); ++i)
                visit(truth.x(i), y);
        }
    };
    for_each([&](int x, int y) { truth_.set(x, y); });
    matcher_->set_left(truth_.words());
    for_each([&](int x, int y) { truth_.clear(x, y); });
    return matcher_->match();
}

}  // namespace ink::score
