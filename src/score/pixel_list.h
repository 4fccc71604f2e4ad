#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/image.h"
#include "edge/bit_mask.h"

namespace ink::score {

/// The pixels of a set, row by row and from left to right: lines cover a percent or two of an
/// image, so everything after the thinning works on these lists and not on images.
class PixelList {
  public:
    PixelList() = default;

    /// The pixels of `image` that hold `label`; any value but 0 if `label` is 0.
    explicit PixelList(const core::Image<std::uint8_t>& image, std::uint8_t label = 0);

    /// The pixels of a mask that are at least `band_px` from its frame.
    PixelList(const edge::BitMask& mask, int band_px);

    [[nodiscard]] int width_px() const { return width_px_; }
    [[nodiscard]] int height_px() const { return static_cast<int>(row_begin_.size()) - 1; }
    [[nodiscard]] std::size_t size() const { return x_.size(); }
    [[nodiscard]] bool is_empty() const { return x_.empty(); }

    /// Index of the first pixel of row `y`; `row_begin(height_px())` is size().
    [[nodiscard]] std::size_t row_begin(int y) const {
        return row_begin_[static_cast<std::size_t>(y)];
    }
    /// Column of pixel `i`.
    [[nodiscard]] int x(std::size_t i) const { return x_[i]; }

    /// Calls `visit(x, y)` for each pixel, in order.
    template <class Visit>
    void visit(Visit visit) const {
        for (int y = 0; y < height_px(); ++y) {
            for (std::size_t i = row_begin(y); i < row_begin(y + 1); ++i)
                visit(x(i), y);
        }
    }

    /// Takes out the pixels whose entry in `is_dropped` (one per pixel) is not 0.
    void drop(const std::vector<std::uint8_t>& is_dropped);

  private:
    int width_px_ = 0;
    std::vector<std::int32_t> x_;
    std::vector<std::size_t> row_begin_ = {0};
};

/// A tolerance as whole numbers: which pixels lie within it of a pixel.
///
/// dx*dx + dy*dy <= tolerance^2 decides, where a square within 1e-6 of an integer is that integer
/// (sqrt(13) squared is not 13 in floating point, but is meant).
class Disk {
  public:
    /// `tolerance_px` >= 0 and finite.
    explicit Disk(double tolerance_px);

    [[nodiscard]] int radius_px() const { return static_cast<int>(half_width_.size()) - 1; }
    /// The largest |dx| in row `dy` of the disk, |dy| <= radius_px().
    [[nodiscard]] int half_width_px(int dy) const {
        return half_width_[static_cast<std::size_t>(dy < 0 ? -dy : dy)];
    }

  private:
    std::vector<int> half_width_;
};

/// Calls `visit(i, first, last)` for each pixel i of `from`, in order, and each row of the disk
/// round it that holds pixels of `to`: they are first..last-1. Both lists are of images of one
/// height.
template <class Visit>
void visit_reach(const PixelList& from, const PixelList& to, const Disk& disk, Visit visit) {
    assert(from.height_px() == to.height_px());
    const int radius = disk.radius_px();
    // What a row of the disk holds moves to the right with the pixel, so each end only ever
    // advances.
    struct Window {
        std::size_t first, last, row_end;
    };
    std::vector<Window> windows;
    for (int y = 0; y < from.height_px(); ++y) {
        const int y_first = std::max(0, y - radius);
        const int y_last = std::min(to.height_px() - 1, y + radius);
        windows.clear();
        for (int v = y_first; v <= y_last; ++v) {
            windows.push_back({to.row_begin(v), to.row_begin(v), to.row_begin(v + 1)});
        }
        for (std::size_t i = from.row_begin(y); i < from.row_begin(y + 1); ++i) {
            for (int v = y_first; v <= y_last; ++v) {
                Window& w = windows[static_cast<std::size_t>(v - y_first)];
                const int half_width = disk.half_width_px(v - y);
                while (w.first < w.row_end && to.x(w.first) < from.x(i) - half_width)
                    ++w.first;
                while (w.last < w.row_end && to.x(w.last) <= from.x(i) + half_width)
                    ++w.last;
                if (w.last > w.first) visit(i, w.first, w.last);
            }
        }
    }
}

/// For each pixel of `from`: 1 if a pixel of `to` lies within `disk` of it, else 0.
[[nodiscard]] std::vector<std::uint8_t> within_reach(const PixelList& from,
                                                     const PixelList& to,
                                                     const Disk& disk);

/// All pixels of the image that have one of `pixels` within the disk.
[[nodiscard]] edge::BitMask reach_of(const PixelList& pixels, const Disk& disk);

/// The pixels that count if something is drawn there: not closer than `band_px` to the frame, and
/// with a true pixel within the disk if there is an ignored one.
[[nodiscard]] edge::BitMask countable_pixels(const PixelList& truth,
                                             const PixelList& ignore,
                                             const Disk& disk,
                                             int band_px);

}  // namespace ink::score
