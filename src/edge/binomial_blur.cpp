#include "edge/binomial_blur.h"

#include <cassert>

#include "edge/binomial_blur_kernel.h"
#include "edge/row_bands.h"

namespace ink::edge {
namespace {

template <class T>
void blur(const core::ImageView<const T>& codes,
          const core::ImageView<T>& out,
          int code_bits,
          int threads) {
    assert(codes.width_px == out.width_px && codes.height_px == out.height_px);
    assert(code_bits >= 0 && code_bits <= 8 * static_cast<int>(sizeof(T)));
    for_row_bands(codes.height_px, threads, [&](int y0, int y1) {
        const T* mid = codes.row(y0);
        blur_rows({.up = mid - codes.stride,
                   .mid = mid,
                   .down = mid + codes.stride,
                   .stride = codes.stride,
                   .out = out.row(y0),
                   .out_stride = out.stride,
                   .width = codes.width_px,
                   .height = y1 - y0,
                   .code_bits = code_bits});
    });
}

}  // namespace

void binomial_blur(const core::ImageView<const std::uint8_t>& codes,
                   const core::ImageView<std::uint8_t>& out,
                   int code_bits,
                   int threads) {
    blur(codes, out, code_bits, threads);
}

void binomial_blur(const core::ImageView<const std::uint16_t>& codes,
                   const core::ImageView<std::uint16_t>& out,
                   int code_bits,
                   int threads) {
    blur(codes, out, code_bits, threads);
}

void binomial_blur_row(const std::uint8_t* up,
                       const std::uint8_t* mid,
                       const std::uint8_t* down,
                       std::uint8_t* out,
                       int width,
                       int code_bits) {
    assert(code_bits >= 0 && code_bits <= 8);
    blur_rows({up, mid, down, 0, out, 0, width, 1, code_bits});
}

void binomial_blur_row(const std::uint16_t* up,
                       const std::uint16_t* mid,
                       const std::uint16_t* down,
                       std::uint16_t* out,
                       int width,
                       int code_bits) {
    assert(code_bits >= 0 && code_bits <= 16);
    blur_rows({up, mid, down, 0, out, 0, width, 1, code_bits});
}

}  // namespace ink::edge
