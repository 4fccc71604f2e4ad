#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/pass/triangle_stage.h"

namespace ink::raster {

/// Where a set-up triangle lies: batches[batch].triangles[index].
struct BinEntry {
    std::uint32_t batch = 0;
    std::uint32_t index = 0;
};

/// How an image is cut into tiles of kTileSize_px, row by row; the last ones may be smaller.
struct TileGrid {
    int width_px = 0;
    int height_px = 0;
    int halo_px = 0;

    [[nodiscard]] int columns() const { return (width_px + kTileSize_px - 1) / kTileSize_px; }
    [[nodiscard]] int rows() const { return (height_px + kTileSize_px - 1) / kTileSize_px; }
    [[nodiscard]] int count() const { return columns() * rows(); }
    /// The tile's own pixels.
    [[nodiscard]] PixelRect own(int tile) const;
    /// Own pixels and halo, as far as the image goes: what is rasterized for it.
    [[nodiscard]] PixelRect drawn(int tile) const;
};

/// Tiles next to each other: columns and rows, the last included.
struct TileRange {
    int column0 = 0;
    int row0 = 0;
    int column1 = 0;
    int row1 = 0;

    /// Those whose drawn pixels `bounds` touches, which lies in the image in part.
    TileRange(const TileGrid& grid, const PixelRect& bounds)
        : column0(std::max(bounds.x0 - grid.halo_px, 0) / kTileSize_px),
          row0(std::max(bounds.y0 - grid.halo_px, 0) / kTileSize_px),
          column1(std::min((bounds.x1 - 1 + grid.halo_px) / kTileSize_px, grid.columns() - 1)),
          row1(std::min((bounds.y1 - 1 + grid.halo_px) / kTileSize_px, grid.rows() - 1)) {}

    [[nodiscard]] bool is_one() const { return column0 == column1 && row0 == row1; }
    /// Calls visit(tile) for each.
    template <class Visit>
    void for_each(const TileGrid& grid, const Visit& visit) const {
        for (int row = row0; row <= row1; ++row) {
            for (int column = column0; column <= column1; ++column)
                visit(row * grid.columns() + column);
        }
    }
};

/// Whether some edge has the whole rectangle on its outer side.
[[nodiscard]] inline bool misses(const SetupTriangle& t, const PixelRect& rect) {
    for (const EdgeFunction& e : t.edges) {
        const int x = e.dx > 0 ? rect.x1 - 1 : rect.x0;
        const int y = e.dy > 0 ? rect.y1 - 1 : rect.y0;
        if (e.at(x, y) < 0) return true;
    }
    return false;
}

/// Calls visit(tile) for the tiles whose drawn pixels the triangle may touch.
template <class Visit>
void for_each_tile(const TileGrid& grid, const SetupTriangle& t, Visit visit) {
    const TileRange range(grid, t.bounds);
    // A box of one row or column of tiles has no corner tiles that a triangle could miss by much.
    const bool is_wide = range.column1 > range.column0 && range.row1 > range.row0;
    range.for_each(grid, [&](int tile) {
        if (!is_wide || !misses(t, grid.drawn(tile))) visit(static_cast<std::size_t>(tile));
    });
}

/// For every tile the triangles that may touch its drawn pixels, in submission order.
class Bins {
  public:
    /// A triangle is in a tile's list if its bounds meet the tile's drawn pixels and none of its
    /// edges has all of them on the outer side.
    Bins(const TileGrid& grid, const std::vector<Batch>& batches, int threads);

    [[nodiscard]] std::span<const BinEntry> of(int tile) const {
        const auto at = static_cast<std::size_t>(tile);
        return {entries_.data() + first_[at], first_[at + 1] - first_[at]};
    }

  private:
    std::vector<BinEntry> entries_;
    std::vector<std::size_t> first_;  ///< per tile, and the end
};

}  // namespace ink::raster
