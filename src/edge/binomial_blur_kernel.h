#pragma once

#include <cstddef>
#include <cstdint>

namespace ink::edge {

/// Rows to blur and where they go. Row y reads up, mid and down plus y strides; with height 1 the
/// three may lie anywhere.
template <class T>
struct BlurRows {
    const T* up;
    const T* mid;
    const T* down;
    std::ptrdiff_t stride;
    T* out;
    std::ptrdiff_t out_stride;
    int width;
    int height;
    int code_bits;
};

/// The blur on the best SIMD target: `binomial_blur` of binomial_blur.h without checks and threads.
void blur_rows(const BlurRows<std::uint8_t>& rows);
void blur_rows(const BlurRows<std::uint16_t>& rows);

}  // namespace ink::edge
