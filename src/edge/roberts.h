#pragma once

#include "core/image.h"

namespace ink::edge {

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
