#include "experiment/drawn_methods.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace ink::experiment {

std::optional<DrawnMethods> DrawnAhead::take(const AskedView& asked) {
    const auto found = std::find_if(expected_.begin(), expected_.end(), [&](const Expected& one) {
        return one.asked == asked;
    });
    if (found == expected_.end()) return std::nullopt;
    std::optional<DrawnMethods> drawn = std::move(found->drawn);
    expected_.erase(found);
    return drawn;
}

std::vector<AskedView> DrawnAhead::to_draw(const AskedView& asked, std::size_t most) const {
    std::vector<AskedView> views;
    for (const Expected& one : expected_) {
        if (views.size() == most) break;
        const scene::View& view = *one.asked.view;
        const bool has_size =
            view.width_px == asked.view->width_px && view.height_px == asked.view->height_px;
        if (has_size && !one.drawn) views.push_back(one.asked);
    }
    return views;
}

void DrawnAhead::keep(const AskedView& asked, DrawnMethods drawn) {
    const auto found = std::find_if(expected_.begin(), expected_.end(), [&](const Expected& one) {
        return one.asked == asked;
    });
    assert(found != expected_.end());
    found->drawn = std::move(drawn);
}

}  // namespace ink::experiment
