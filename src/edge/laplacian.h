#pragma once

#include <cstdint>

#include "core/image.h"

namespace ink::edge {

/// How the output of MOTE's filter becomes an edge response.
enum class Response {
    absolute,  ///< |L|: a line two pixels wide, one on each side of a step
    positive,  ///< max(L, 0): a line one pixel wide, on the high side
    wrap,  ///< L modulo 2^code_bits, shifted and masked: the literal uint8 reading of the source
};

/// "Scaling the output and clipping some bits off": edge response = min(255, (v with its low
/// `clip_bits` cleared) << scale_bits), v the response. With clip_bits >= 2, |L| <= 2 gives 0.
///
/// `wrap` keeps the low 8 bits of the shifted value instead of its minimum with 255, as a uint8
/// would; a small negative L is then a strong line.
struct LaplacianResponse {
    Response response = Response::absolute;
    int clip_bits = 2;        ///< 0..15 low bits cleared before scaling
    int scale_bits = 0;       ///< -15..15: shift left (right if negative) after it
    int code_bits = 8;        ///< 1..16: bits of the filtered code
    bool code_wraps = false;  ///< the code is known modulo 2^code_bits only, and so is L, which is
                              ///< then taken between -2^(code_bits-1) and 2^(code_bits-1) - 1
};

/// The edge response of one Laplacian value, |laplacian| <= 4 * 65535.
[[nodiscard]] std::uint8_t respond(int laplacian, const LaplacianResponse& response);

/// The filter 0 -1 0 / -1 4 -1 / 0 -1 0 over an image or a tile of one: out(x, y) = respond(4
/// codes(x, y) - its four neighbours), the same bits on every SIMD target and number of threads.
///
/// `codes` and `out` have one size; the pixels one row above and below `codes` and one column left
/// and right of it must be readable and count as neighbours. `out` overlaps no input. Rows are
/// shared among `threads`; an empty image writes nothing.
void laplacian(const core::ImageView<const std::uint8_t>& codes,
               const core::ImageView<std::uint8_t>& out,
               const LaplacianResponse& response,
               int threads = 1);
void laplacian(const core::ImageView<const std::uint16_t>& codes,
               const core::ImageView<std::uint8_t>& out,
               const LaplacianResponse& response,
               int threads = 1);

}  // namespace ink::edge
