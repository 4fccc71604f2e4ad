#pragma once

#include <cstddef>
#include <vector>

#include "score/pixel_list.h"

namespace ink::score {

/// The plainest exact matcher, the referee of the quick one: it lists who may be matched with whom,
/// and gives each pixel of the left set a place, moving others if need be (Kuhn's algorithm).
class PlainMatching {
  public:
    PlainMatching(const PixelList& left, const PixelList& right, const Disk& disk)
        : wishes_(left.size()), owner_(right.size(), kFree) {
        visit_reach(left, right, disk, [&](std::size_t i, std::size_t first, std::size_t last) {
            for (std::size_t j = first; j < last; ++j)
                wishes_[i].push_back(j);
        });
        for (std::size_t i = 0; i < wishes_.size(); ++i) {
            is_tried_.assign(owner_.size(), false);
            size_ += place(i) ? 1 : 0;
        }
    }

    [[nodiscard]] int size() const { return size_; }

  private:
    static constexpr std::size_t kFree = ~std::size_t{0};

    bool place(std::size_t i) {
        for (const std::size_t j : wishes_[i]) {
            if (is_tried_[j]) continue;
            is_tried_[j] = true;
            if (owner_[j] != kFree && !place(owner_[j])) continue;
            owner_[j] = i;
            return true;
        }
        return false;
    }

    std::vector<std::vector<std::size_t>> wishes_;  ///< per left pixel
    std::vector<std::size_t> owner_;                ///< per right pixel
    std::vector<bool> is_tried_;
    int size_ = 0;
};

}  // namespace ink::score
