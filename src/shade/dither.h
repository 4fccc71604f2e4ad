#pragma once

#include <array>
#include <cstdint>

#include "core/image.h"
#include "shade/compose.h"

namespace ink::shade {

/// What a frame buffer keeps of a colour.
enum class DitherFormat {
    none,    ///< all of it
    rgb565,  ///< 5, 6 and 5 bits
    rgb332,  ///< 3, 3 and 2 bits
};

/// Ranks 0..15 of a 4x4 square (Bayer 1973): the order in which its pixels are raised.
inline constexpr std::array<std::array<std::uint8_t, 4>, 4> kBayer4 = {
    {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};

/// Per channel the highest level of a format: 31, 63, 31 or 7, 7, 3; 255 for `none`.
[[nodiscard]] std::array<int, 3> top_levels(DitherFormat format);

/// Ordered dither, as 1998 saved bits: each channel becomes one of the two levels about it, by
/// place.
///
/// Of value v and top level t, v t / 255 is cut to whole levels, and a level is added where the
/// rest exceeds (rank + 1/2) / 16. So an even colour keeps its mean over 4x4 pixels within 1/32
/// level, and a colour that is a level stays as it is. Levels come back as 0..255, rounded.
[[nodiscard]] core::Image<Rgb> dither(core::Image<Rgb> image, DitherFormat format);

}  // namespace ink::shade
