#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "raster/pass/needed_rows.h"
#include "raster/pass/tile_buffer.h"

namespace ink::raster {

/// Which rows of a tile are drawn, a run (in the image's coordinates) per vector of 16 pixels
/// from the first of the tile's margin on.
struct DrawnRows {
    std::array<RowRun, kStencilColumns + 1> of;

    /// All that is to be rasterized.
    static DrawnRows all(const TileBuffer& tile) {
        DrawnRows rows;
        rows.of.fill({tile.drawn().y0, tile.drawn().y1});
        return rows;
    }

    /// What the needed stencils read: a column of them reaches into two vectors.
    static DrawnRows under(const NeededRows& needed, const TileBuffer& tile, int halo_px) {
        static_assert(kTileMargin_px == kStencilColumn_px / 2 && kMaxHalo_px <= kTileMargin_px);
        DrawnRows rows;
        for (std::size_t i = 0; i < needed.of.size(); ++i) {
            const RowRun& run = needed.of[i];
            if (run.is_empty()) continue;
            const int y0 = tile.own().y0;
            const RowRun read{std::max(y0 + run.begin - halo_px, tile.drawn().y0),
                              std::min(y0 + run.end + halo_px, tile.drawn().y1)};
            rows.of[i] = joined(rows.of[i], read);
            rows.of[i + 1] = read;
        }
        return rows;
    }

    /// The rectangle that holds them.
    [[nodiscard]] PixelRect hull(const TileBuffer& tile) const {
        RowRun rows;
        PixelRect rect{tile.drawn().x1, 0, tile.drawn().x0, 0};
        for (std::size_t i = 0; i < of.size(); ++i) {
            if (of[i].is_empty()) continue;
            const int x0 = tile.own().x0 - kTileMargin_px + static_cast<int>(i) * kStencilColumn_px;
            rows = joined(rows, of[i]);
            rect.x0 = std::min(rect.x0, std::max(x0, tile.drawn().x0));
            rect.x1 = std::max(rect.x1, std::min(x0 + kStencilColumn_px, tile.drawn().x1));
        }
        rect.y0 = rows.begin;
        rect.y1 = rows.end;
        return rect;
    }
};

}  // namespace ink::raster
