#pragma once

#include <cstdint>

#include "core/image.h"

namespace ink::edge {

/// One row of the 3 x 3 binomial blur 1 2 1 / 2 4 2 / 1 2 1 over 16, rounded to nearest: MOTE's
/// "slight blur" before its filter, which makes fatter lines.
///
/// `code_bits` = 0 blurs plain numbers. Else the values are codes modulo 2^code_bits, and each
/// neighbour counts by its shortest way round from the middle one, so that a wrapped ramp stays a
/// ramp. [-1] and [width] of every row must be readable; `out` overlaps no input.
void binomial_blur_row(const std::uint8_t* up,
                       const std::uint8_t* mid,
                       const std::uint8_t* down,
                       std::uint8_t* out,
                       int width,
                       int code_bits);
void binomial_blur_row(const std::uint16_t* up,
                       const std::uint16_t* mid,
                       const std::uint16_t* down,
                       std::uint16_t* out,
                       int width,
                       int code_bits);

/// The same over an image or a tile of one, rows shared among `threads`: the same bits on every
/// SIMD target and number of threads. Both have one size; one pixel round `codes` must be readable.
void binomial_blur(const core::ImageView<const std::uint8_t>& codes,
                   const core::ImageView<std::uint8_t>& out,
                   int code_bits,
                   int threads = 1);
void binomial_blur(const core::ImageView<const std::uint16_t>& codes,
                   const core::ImageView<std::uint16_t>& out,
                   int code_bits,
                   int threads = 1);

}  // namespace ink::edge
