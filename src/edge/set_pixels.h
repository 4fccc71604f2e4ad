#pragma once

#include <cstdint>
#include <cstring>

#include "core/image.h"

namespace ink::edge {

/// Calls `visit(x)` for each of the `width_px` bytes at `row` that is not 0, from left to right.
///
/// Lines cover a percent or two of an image, so eight bytes are passed over at once where all are
/// 0.
template <class Visit>
void visit_set_pixels(const std::uint8_t* row, int width_px, Visit visit) {
    int x = 0;
    for (; x + 8 <= width_px; x += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, row + x, sizeof word);
        if (word == 0) continue;
        for (int i = x; i < x + 8; ++i) {
            if (row[i] != 0) visit(i);
        }
    }
    for (; x < width_px; ++x) {
        if (row[x] != 0) visit(x);
    }
}

/// Calls `visit(x, y)` for each pixel of an image that is not 0, row by row.
template <class Visit>
void visit_set_pixels(const core::Image<std::uint8_t>& image, Visit visit) {
    for (int y = 0; y < image.height_px(); ++y)
        visit_set_pixels(image.row(y), image.width_px(), [&](int x) { visit(x, y); });
}

}  // namespace ink::edge
