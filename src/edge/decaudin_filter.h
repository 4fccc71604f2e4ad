#pragma once

#include <cstdint>

namespace ink::edge {

/// Where the sensitivity k stands in Decaudin's p.
enum class KPlace {
    inside,   ///< ((gmax - gmin) / k)^2
    outside,  ///< (gmax - gmin)^2 / k
};

/// One row of Decaudin's first operator (Cartoon-looking rendering of 3D-scenes, INRIA RR-2919,
/// 1996): g = (|A-x| + 2|B-x| + |C-x| + 2|D-x| + 2|E-x| + |F-x| + 2|G-x| + |H-x|) / 8, A..H the
/// eight neighbours of x row by row.
///
/// [-1] and [width] of every row must be readable; `g` overlaps no input.
void decaudin_g_row(const float* up, const float* mid, const float* down, float* g, int width);

/// The sensitivity of one kind of channel.
struct DecaudinK {
    float k = 1;  ///< > 0
    KPlace place = KPlace::inside;
};

/// One row of his second operator, p = min(((gmax - gmin) / k)^2, 1), the extremes taken over the
/// 3 x 3 pixels round each. [-1] and [width] of every row must be readable; `p` overlaps no input.
void decaudin_p_row(const float* g_up,
                    const float* g_mid,
                    const float* g_down,
                    float* p,
                    int width,
                    const DecaudinK& k);

}  // namespace ink::edge
