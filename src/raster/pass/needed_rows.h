#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "raster/pass/pass.h"

namespace ink::raster {

/// Rows [begin, end).
struct RowRun {
    int begin = 0;
    int end = 0;

    [[nodiscard]] bool is_empty() const { return begin >= end; }
    [[nodiscard]] int count() const { return std::max(end - begin, 0); }
};

/// The least run that holds both.
[[nodiscard]] inline RowRun joined(const RowRun& a, const RowRun& b) {
    if (a.is_empty()) return b;
    if (b.is_empty()) return a;
    return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

/// Columns in which stencils are told apart: the halves of two vectors of pixels each.
inline constexpr int kStencilColumn_px = 16;
inline constexpr std::size_t kStencilColumns = kTileSize_px / kStencilColumn_px;

/// Which stencils of a tile need to be looked at: a run of its own rows per column of 16 px. All
/// others give 0.
struct NeededRows {
    std::array<RowRun, kStencilColumns> of;

    /// Those of any column.
    [[nodiscard]] RowRun hull() const {
        RowRun all;
        for (const RowRun& run : of)
            all = joined(all, run);
        return all;
    }
};

}  // namespace ink::raster
