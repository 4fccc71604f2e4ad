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

}  // namespace ink::edge
