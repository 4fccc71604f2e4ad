#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "core/image.h"
#include "core/parallel.h"

namespace ink::edge {

/// Calls `body(y0, y1)` for bands of rows that cover [0, height_px) once, on at most `threads`
/// threads. One thread gets one band; more get four each, so that a slow one costs little.
///
/// `body` writes the rows of its own band only. No rows, no call.
template <class Body>
void for_row_bands(int height_px, int threads, Body body) {
    assert(threads >= 1);
    if (height_px <= 0) return;
    if (threads == 1) return body(0, height_px);
    // Multiples of eight rows: kernels take some rows at once.
    const int rows = std::max(8, (height_px / (4 * threads) + 7) / 8 * 8);
    const int bands = (height_px + rows - 1) / rows;
    core::parallel_for(static_cast<std::size_t>(bands), threads, [&](std::size_t band) {
        const int y0 = static_cast<int>(band) * rows;
        body(y0, std::min(y0 + rows, height_px));
    });
}

/// Calls `kernel(from, to)` for bands of the rows of two images of one size: the face of a filter
/// from pixels to pixels.
template <class T, class Out, class Kernel>
void filter_row_bands(const core::ImageView<const T>& values,
                      const core::ImageView<Out>& out,
                      int threads,
                      Kernel kernel) {
    assert(values.width_px == out.width_px && values.height_px == out.height_px);
    for_row_bands(out.height_px, threads, [&](int y0, int y1) {
        kernel(core::ImageView<const T>{values.row(y0), out.width_px, y1 - y0, values.stride},
               core::ImageView<Out>{out.row(y0), out.width_px, y1 - y0, out.stride});
    });
}

}  // namespace ink::edge
