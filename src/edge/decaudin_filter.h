#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/image.h"

namespace ink::edge {

/// Where the sensitivity k stands in Decaudin's p.
enum class KPlace {
    inside,   ///< ((gmax - gmin) / k)^2
    outside,  ///< (gmax - gmin)^2 / k
};

/// The sensitivity of one kind of channel.
struct DecaudinK {
    float k = 1;  ///< > 0
    KPlace place = KPlace::inside;
};

/// One row of Decaudin's second operator, p = min(((gmax - gmin) / k)^2, 1), the extremes taken
/// over the 3 x 3 pixels round each. [-1] and [width] of every row must be readable; `p` overlaps
/// no input.
void decaudin_p_row(const float* g_up,
                    const float* g_mid,
                    const float* g_down,
                    float* p,
                    int width,
                    const DecaudinK& k);

/// How the p of several channels become one number.
enum class DecaudinJoin {
    max,     ///< the largest
    either,  ///< a + b - a b
    length,  ///< the root of the sum of squares
};

/// One of the channels that are joined: depth, or a component of the normal.
struct DecaudinChannel {
    const float* origin = nullptr;  ///< pixel (0, 0); two pixels round the image must be readable
    std::ptrdiff_t stride = 0;      ///< floats from one row to the next
    DecaudinK k;
};

inline constexpr std::size_t kMaxDecaudinChannels = 4;

/// The whole filter over an image or a tile of one (Cartoon-looking rendering of 3D-scenes, INRIA
/// RR-2919, 1996): the p of 1 to 4 channels, joined, as edge responses: min(p, 1) times 255,
/// rounded to nearest. The p are of g = (|A-x| + 2|B-x| + |C-x| + 2|D-x| + 2|E-x| + |F-x| + 2|G-x|
/// + |H-x|) / 8, A..H the eight neighbours of x row by row.
///
/// The same bits as the row above, on every SIMD target and number of threads, for finite values.
/// What lies round the image counts as neighbours; `out` overlaps no input. Rows are shared among
/// `threads`; an empty image writes nothing.
void decaudin(std::span<const DecaudinChannel> channels,
              DecaudinJoin join,
              const core::ImageView<std::uint8_t>& out,
              int threads = 1);

}  // namespace ink::edge
