#include "score/pixel_list.h"

#include <cmath>

#include "edge/set_pixels.h"

namespace ink::score {

PixelList::PixelList(const core::Image<std::uint8_t>& image, std::uint8_t label)
    : width_px_(image.width_px()) {
    row_begin_.reserve(static_cast<std::size_t>(image.height_px()) + 1);
    for (int y = 0; y < image.height_px(); ++y) {
        const std::uint8_t* row = image.row(y);
        edge::visit_set_pixels(row, image.width_px(), [&](int x) {
            if (label == 0 || row[x] == label) x_.push_back(x);
        });
        row_begin_.push_back(x_.size());
    }
}

PixelList::PixelList(const edge::BitMask& mask, int band_px) : width_px_(mask.width_px()) {
    row_begin_.reserve(static_cast<std::size_t>(mask.height_px()) + 1);
    const int x_end = mask.width_px() - band_px;
    for (int y = 0; y < mask.height_px(); ++y) {
        if (y >= band_px && y < mask.height_px() - band_px) {
            mask.visit_row(y, [&](int x) {
                if (x >= band_px && x < x_end) x_.push_back(x);
            });
        }
        row_begin_.push_back(x_.size());
    }
}

void PixelList::drop(const std::vector<std::uint8_t>& is_dropped) {
    assert(is_dropped.size() == size());
    std::size_t kept = 0;
    std::size_t i = 0;
    for (std::size_t y = 1; y < row_begin_.size(); ++y) {
        for (; i < row_begin_[y]; ++i) {
            if (is_dropped[i] == 0) x_[kept++] = x_[i];
        }
        row_begin_[y] = kept;
    }
    x_.resize(kept);
}

Disk::Disk(double tolerance_px) {
    assert(tolerance_px >= 0 && std::isfinite(tolerance_px));
    const double square = tolerance_px * tolerance_px;
    const double nearest = std::round(square);
    // Squared distances are whole, so the floor decides as the square itself would.
    const auto limit =
        static_cast<std::int64_t>(std::abs(square - nearest) < 1e-6 ? nearest : std::floor(square));
    for (std::int64_t dy = 0; dy * dy <= limit; ++dy) {
        int dx = 0;
        while (dy * dy + std::int64_t{dx + 1} * (dx + 1) <= limit)
            ++dx;
        half_width_.push_back(dx);
    }
}

std::vector<std::uint8_t> within_reach(const PixelList& from,
                                       const PixelList& to,
                                       const Disk& disk) {
    std::vector<std::uint8_t> is_reached(from.size());
    visit_reach(
        from, to, disk, [&](std::size_t i, std::size_t, std::size_t) { is_reached[i] = 1; });
    return is_reached;
}

}  // namespace ink::score
