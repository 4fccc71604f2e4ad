#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "raster/pass/needed_rows.h"
#include "raster/pass/setup.h"
#include "raster/pass/tile_buffer.h"

namespace ink::raster {

/// Where a triangle meets the columns of a tile's stencils, which are wider than the columns by the
/// halo: rows, counted from the tile's first drawn one.
class TriangleRows {
  public:
    TriangleRows(const SetupTriangle& t, const TileBuffer& tile, int halo_px) {
        const PixelRect& drawn = tile.drawn();
        const double top = std::max(t.bounds.y0 - drawn.y0, 0);
        const double bottom = std::min(t.bounds.y1, drawn.y1) - drawn.y0;
        inside_begin_.fill(top);
        touched_begin_.fill(top);
        inside_end_.fill(bottom);
        touched_end_.fill(bottom);
        for (const EdgeFunction& edge : t.edges)
            cut(edge, tile.own().x0 - halo_px, drawn.y0, kStencilColumn_px + 2 * halo_px - 1);
        for (std::size_t i = 0; i < kStencilColumns; ++i) {
            const int x0 = tile.own().x0 + static_cast<int>(i) * kStencilColumn_px;
            const bool is_across =
                t.bounds.x0 <= x0 - halo_px && t.bounds.x1 >= x0 + kStencilColumn_px + halo_px;
            if (!is_across) inside_end_[i] = -1;
        }
    }

    /// Every centre is inside in these.
    [[nodiscard]] RowRun inside(std::size_t column) const {
        return {static_cast<int>(std::ceil(inside_begin_[column])),
                static_cast<int>(std::floor(inside_end_[column]))};
    }
    /// No centre is inside beyond these.
    [[nodiscard]] RowRun touched(std::size_t column) const {
        return {static_cast<int>(std::floor(touched_begin_[column])),
                static_cast<int>(std::ceil(touched_end_[column]))};
    }

  private:
    /// A row is a quotient, exact but for rounding: each is moved by more than that, to where it
    /// proves less.
    void cut(const EdgeFunction& e, int x0, int y0, int last) {
        constexpr double kMargin = 1e-6;
        const double least = static_cast<double>(e.at(e.dx > 0 ? x0 : x0 + last, y0));
        const double most = static_cast<double>(e.at(e.dx > 0 ? x0 + last : x0, y0));
        const double step = static_cast<double>(e.dx) * kStencilColumn_px;
        if (e.dy == 0) {
            for (std::size_t i = 0; i < kStencilColumns; ++i) {
                const double along = static_cast<double>(i) * step;
                if (least + along < 0) inside_end_[i] = -1;
                if (most + along < 0) touched_end_[i] = -1;
            }
            return;
        }
        const double per_row = 1 / static_cast<double>(e.dy);
        for (std::size_t i = 0; i < kStencilColumns; ++i) {
            // The edge is crossed at these rows.
            const double along = static_cast<double>(i) * step;
            const double inside = limited(-(least + along) * per_row);
            const double touched = limited(-(most + along) * per_row);
            if (e.dy > 0) {  // inside from there on
                inside_begin_[i] = std::max(inside_begin_[i], inside + kMargin);
                touched_begin_[i] = std::max(touched_begin_[i], touched - kMargin);
            } else {  // up to there, that row included
                inside_end_[i] = std::min(inside_end_[i], inside - kMargin + 1);
                touched_end_[i] = std::min(touched_end_[i], touched + kMargin + 1);
            }
        }
    }
    /// Far enough for any tile, and for an int.
    static double limited(double row) { return std::min(std::max(row, -1e6), 1e6); }

    using Rows = std::array<double, kStencilColumns>;
    Rows inside_begin_;
    Rows inside_end_;
    Rows touched_begin_;
    Rows touched_end_;
};

}  // namespace ink::raster
