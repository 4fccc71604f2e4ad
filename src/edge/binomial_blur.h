#pragma once

#include <cstdint>

#include "core/image.h"

namespace ink::edge {

/// The 3 x 3 binomial blur 1 2 1 / 2 4 2 / 1 2 1 over 16, rounded to nearest: MOTE's "slight blur"
/// before its filter, which makes fatter lines.
///
/// `code_bits` = 0 blurs plain numbers. Else the values are codes modulo 2^code_bits, and each
/// neighbour counts by its shortest way round from the middle one, so that a wrapped ramp stays a
/// ramp. Both images, or tiles of one, have one size; one pixel round `codes` must be readable.
/// `out` overlaps no input. Rows are shared among `threads`: the same bits on every SIMD target and
/// number of threads. An empty image writes nothing.
void binomial_blur(const core::ImageView<const std::uint8_t>& codes,
                   const core::ImageView<std::uint8_t>& out,
                   int code_bits,
                   int threads = 1);
void binomial_blur(const core::ImageView<const std::uint16_t>& codes,
                   const core::ImageView<std::uint16_t>& out,
                   int code_bits,
                   int threads = 1);

}  // namespace ink::edge
