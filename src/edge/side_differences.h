#pragma once

#include <cstdint>

#include "core/image.h"

namespace ink::edge {

/// Which neighbours a pixel is held against.
enum class Sides {
    square,   ///< the four sides of the square of samples from (x, y) to (x + 1, y + 1)
    forward,  ///< from (x, y) to the next sample to the right, and to the next one below
};

/// The largest difference of codes over a pixel's sides: out = min(255, 2^gain_bits * max |a - b|).
///
/// Both images have one size; one column right of `codes` and one row below must be readable and
/// count as neighbours. `out` overlaps no input. gain_bits 0..8. The same bits on every SIMD
/// target. An empty image writes nothing.
void side_differences(const core::ImageView<const std::uint8_t>& codes,
                      const core::ImageView<std::uint8_t>& out,
                      Sides sides,
                      int gain_bits);

/// When depth jumps from one sample to the next, and does not only run on or bend.
///
/// Of four samples in line, j is the difference of q = 1/distance between the middle two, s0 and s1
/// are those before and after. Depth jumps where both
///
///     max(j - max(s0, s1), min(s0, s1) - j) > least_share * (larger q of the middle two) + slack
///     |j| > ratio * max(|s0|, |s1|)
///
/// The first is 0 or less on a plane and at a bend of any strength.
struct DepthJump {
    float least_share = 0;
    float slack = 0;  ///< and a length of its own, and what rounding of q may add up to
    float ratio = 0;
};

/// Sets the pixels of `out` to 255 that have a jump of depth on one of their sides; leaves others.
///
/// Both images have one size; of `q` one column on the left and one row above must be readable, and
/// two on the right and below. `out` does not overlap `q`. The same bits on every SIMD target.
void add_depth_jumps(const core::ImageView<const float>& q,
                     const core::ImageView<std::uint8_t>& out,
                     Sides sides,
                     const DepthJump& jump);

}  // namespace ink::edge
