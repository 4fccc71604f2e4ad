#pragma once

#include "edge/bit_mask.h"
#include "score/pixel_list.h"

namespace ink::score {

/// All pixels of the image that have one of `pixels` within the disk.
[[nodiscard]] edge::BitMask reach_of(const PixelList& pixels, const Disk& disk);

/// The pixels that count if something is drawn there: not closer than `band_px` to the frame, and
/// with a true pixel within the disk if there is an ignored one.
[[nodiscard]] edge::BitMask countable_pixels(const PixelList& truth,
                                             const PixelList& ignore,
                                             const Disk& disk,
                                             int band_px);

}  // namespace ink::score
