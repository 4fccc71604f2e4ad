#pragma once

#include "core/image.h"

namespace ink::edge {

/// Saito and Takahashi's differentials of an image whose pixel X has the neighbours A B C / D X E
/// / F G H.
///
/// Source: T. Saito and T. Takahashi, "Comprehensible rendering of 3-D shapes", SIGGRAPH 1990.
enum class Differential {
    first,   ///< (|A + 2B + C - F - 2G - H| + |C + 2E + H - A - 2D - F|) / 8: Sobel's
    second,  ///< |8X - A - B - C - D - E - F - G - H| / 3
};

/// One differential of every pixel, added in the order row by row (see the plain reference in
/// tests/edge).
///
/// Both images have one size; one pixel round `values` must be readable and counts as neighbour.
/// `out` overlaps no input. Rows are shared among `threads`; the same bits on every SIMD target and
/// number of threads, for finite values. An empty image writes nothing.
void sobel(const core::ImageView<const float>& values,
           Differential differential,
           const core::ImageView<float>& out,
           int threads = 1);

/// Roberts' cross: out(x, y) = |v(x, y) - v(x+1, y+1)| + |v(x+1, y) - v(x, y+1)|. A one-pixel
/// step makes a line one pixel wide, left of or above it.
///
/// Both images have one size; one column right of `values` and one row below must be readable and
/// count as neighbours. `out` overlaps no input. Rows are shared among `threads`; the same bits on
/// every SIMD target and number of threads. An empty image writes nothing.
///
/// Source: L. G. Roberts, "Machine perception of three-dimensional solids", 1963.
void roberts(const core::ImageView<const float>& values,
             const core::ImageView<float>& out,
             int threads = 1);

}  // namespace ink::edge
