#pragma once

#include <cstdint>
#include <cstddef>

namespace ink::edge {

/// How the output of MOTE's filter becomes a strength.
enum class Response {
    absolute,  ///< |L|
    positive,  ///< max(L, 0): a line one pixel wide, on the high side
    wrap,      ///< L modulo 256, shifted and masked: the literal uint8 reading of the source
};

/// "Scaling the output and clipping some bits off": strength = min(255, (v with its low `clip_bits`
/// cleared) << scale_bits), v the response. With clip_bits >= 2, |L| <= 2 gives 0.
struct LaplacianResponse {
    Response response = Response::absolute;
    int clip_bits = 2;   ///< 0..15 low bits cleared before scaling
    int scale_bits = 0;  ///< -8..7: shift left (right if negative) after it
};

/// The strength of one Laplacian value.
[[nodiscard]] std::uint8_t respond(int laplacian, const LaplacianResponse& response);

/// One row of the filter 0 -1 0 / -1 4 -1 / 0 -1 0: out[x] = respond(4 mid[x] - up[x] - down[x] -
/// mid[x-1] - mid[x+1]) for x in [0, width). mid[-1] and mid[width] must be readable.
void laplacian_row(const std::uint8_t* up,
                   const std::uint8_t* mid,
                   const std::uint8_t* down,
                   std::uint8_t* out,
                   int width,
                   const LaplacianResponse& response);
void laplacian_row(const std::uint16_t* up,
                   const std::uint16_t* mid,
                   const std::uint16_t* down,
                   std::uint8_t* out,
                   int width,
                   const LaplacianResponse& response);

}  // namespace ink::edge
