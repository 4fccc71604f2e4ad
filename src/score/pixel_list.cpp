#include "score/pixel_list.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "edge/set_pixels.h"

namespace ink::score {
namespace {

/// The row of a mask's pixels; `y` within the image.
std::uint64_t* row_of(edge::BitMask& mask, int y) {
    return mask.words().data() + static_cast<std::size_t>(y + 1) * mask.stride() + 1;
}

/// Sets the pixels from `first` to before `end` of a row.
void set_run(std::uint64_t* row, int first, int end) {
    for (int x = first; x < end;) {
        const int stop = std::min(end, (x / 64 + 1) * 64);
        row[x / 64] |= (~std::uint64_t{0} >> (64 - (stop - x))) << (x % 64);
        x = stop;
    }
}

}  // namespace

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

edge::BitMask reach_of(const PixelList& pixels, const Disk& disk) {
    const int width_px = pixels.width_px();
    edge::BitMask mask(width_px, pixels.height_px());
    for (int y = 0; y < pixels.height_px(); ++y) {
        const int first_row = std::max(0, y - disk.radius_px());
        const int last_row = std::min(pixels.height_px() - 1, y + disk.radius_px());
        for (std::size_t i = pixels.row_begin(y); i < pixels.row_begin(y + 1);) {
            const int first = pixels.x(i);
            int last = first;
            for (++i; i < pixels.row_begin(y + 1) && pixels.x(i) == last + 1; ++i)
                ++last;
            for (int v = first_row; v <= last_row; ++v) {
                const int half = disk.half_width_px(v - y);
                set_run(row_of(mask, v),
                        std::max(0, first - half),
                        std::min(width_px, last + half + 1));
            }
        }
    }
    return mask;
}

edge::BitMask countable_pixels(const PixelList& truth,
                               const PixelList& ignore,
                               const Disk& disk,
                               int band_px) {
    const int width_px = truth.width_px();
    const int height_px = truth.height_px();
    edge::BitMask mask(width_px, height_px);
    for (int y = band_px; y < height_px - band_px; ++y)
        set_run(row_of(mask, y), band_px, width_px - band_px);
    if (ignore.is_empty()) return mask;
    edge::BitMask ignored = reach_of(ignore, disk);
    edge::BitMask wanted = reach_of(truth, disk);
    for (std::size_t i = 0; i < mask.words().size(); ++i)
        mask.words()[i] &= ~ignored.words()[i] | wanted.words()[i];
    return mask;
}

}  // namespace ink::score
