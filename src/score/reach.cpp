#include "score/reach.h"

#include <algorithm>
#include <cstdint>

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
