#include "edge/laplacian.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

#include "edge/laplacian_kernel.h"
#include "edge/row_bands.h"

namespace ink::edge {
namespace {

void check(const LaplacianResponse& response, int store_bits) {
    assert(response.clip_bits >= 0 && response.clip_bits <= 15);
    assert(response.scale_bits >= -15 && response.scale_bits <= 15);
    assert(response.code_bits >= 1 && response.code_bits <= store_bits);
    static_cast<void>(response);
    static_cast<void>(store_bits);
}

template <class T>
void filter(const core::ImageView<const T>& codes,
            const core::ImageView<std::uint8_t>& out,
            const LaplacianResponse& response,
            int threads) {
    assert(codes.width_px == out.width_px && codes.height_px == out.height_px);
    check(response, 8 * sizeof(T));
    for_row_bands(codes.height_px, threads, [&](int y0, int y1) {
        const T* mid = codes.row(y0);
        laplacian_rows({.up = mid - codes.stride,
                        .mid = mid,
                        .down = mid + codes.stride,
                        .stride = codes.stride,
                        .out = out.row(y0),
                        .out_stride = out.stride,
                        .width = codes.width_px,
                        .height = y1 - y0},
                       response);
    });
}

/// The value of a number known modulo 2^bits between -2^(bits-1) and 2^(bits-1) - 1.
int nearest_to_zero(int value, int bits) {
    const int modulus = 1 << bits;
    const int low = value & (modulus - 1);
    return low >= modulus / 2 ? low - modulus : low;
}

}  // namespace

std::uint8_t respond(int laplacian, const LaplacianResponse& r) {
    check(r, 16);
    const int keep = ~((1 << r.clip_bits) - 1);
    const int left = std::max(r.scale_bits, 0);
    const int right = std::max(-r.scale_bits, 0);
    if (r.response == Response::wrap) {
        const int v = laplacian & ((1 << r.code_bits) - 1) & keep;
        return static_cast<std::uint8_t>(static_cast<unsigned>(v >> right) << left);
    }
    if (r.code_wraps) laplacian = nearest_to_zero(laplacian, r.code_bits);
    const int read = r.response == Response::absolute ? std::abs(laplacian) : laplacian;
    const int v = (std::max(read, 0) & keep) >> right;
    return v > 255 >> left ? std::uint8_t{255} : static_cast<std::uint8_t>(v << left);
}

void laplacian(const core::ImageView<const std::uint8_t>& codes,
               const core::ImageView<std::uint8_t>& out,
               const LaplacianResponse& response,
               int threads) {
    filter(codes, out, response, threads);
}

void laplacian(const core::ImageView<const std::uint16_t>& codes,
               const core::ImageView<std::uint8_t>& out,
               const LaplacianResponse& response,
               int threads) {
    filter(codes, out, response, threads);
}

void laplacian_row(const std::uint8_t* up,
                   const std::uint8_t* mid,
                   const std::uint8_t* down,
                   std::uint8_t* out,
                   int width,
                   const LaplacianResponse& response) {
    check(response, 8);
    laplacian_rows({up, mid, down, 0, out, 0, width, 1}, response);
}

void laplacian_row(const std::uint16_t* up,
                   const std::uint16_t* mid,
                   const std::uint16_t* down,
                   std::uint8_t* out,
                   int width,
                   const LaplacianResponse& response) {
    check(response, 16);
    laplacian_rows({up, mid, down, 0, out, 0, width, 1}, response);
}

}  // namespace ink::edge
