#pragma once

#include <cstddef>
#include <cstdint>

#include "edge/laplacian.h"

namespace ink::edge {

/// Rows of codes and where their edge responses go. Row y reads up, mid and down plus y strides;
/// with height 1 the three may lie anywhere, with more they are rows under one another.
template <class T>
struct LaplacianRows {
    const T* up;
    const T* mid;
    const T* down;
    std::ptrdiff_t stride;
    std::uint8_t* out;
    std::ptrdiff_t out_stride;
    int width;
    int height;
};

/// The filter on the best SIMD target: `laplacian` of laplacian.h without its checks and threads.
void laplacian_rows(const LaplacianRows<std::uint8_t>& rows, const LaplacianResponse& response);
void laplacian_rows(const LaplacianRows<std::uint16_t>& rows, const LaplacianResponse& response);

}  // namespace ink::edge
