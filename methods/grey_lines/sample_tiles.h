#pragma once

#include <bit>
#include <cstddef>
#include <vector>

#include "raster/pass/bin.h"

namespace ink::methods {

/// What is known of the samples of a frame, by tiles, which different threads may fill. A `Tile`
/// can be cleared.
template <class Tile>
class SampleTiles {
  public:
    static constexpr int kShift = std::countr_zero(unsigned{raster::kTileSize_px});
    static constexpr int kMask = raster::kTileSize_px - 1;
    /// Samples of a tile.
    static constexpr std::size_t kCount = std::size_t{1} << 2 * kShift;

    /// Clears all, for a frame of samples.
    void reset(const raster::TileGrid& grid) {
        grid_ = grid;
        columns_ = grid.columns();
        tiles_.resize(static_cast<std::size_t>(grid.count()));
        for (Tile& tile : tiles_)
            tile.clear();
    }
    [[nodiscard]] const raster::TileGrid& grid() const { return grid_; }
    [[nodiscard]] Tile& of(int x, int y) { return tiles_[tile_at(x, y)]; }
    [[nodiscard]] const Tile& of(int x, int y) const { return tiles_[tile_at(x, y)]; }
    /// Where a sample is among those of its tile.
    [[nodiscard]] static std::size_t place(int x, int y) {
        return static_cast<std::size_t>((y & kMask) << kShift | (x & kMask));
    }

  private:
    [[nodiscard]] std::size_t tile_at(int x, int y) const {
        return static_cast<std::size_t>((y >> kShift) * columns_ + (x >> kShift));
    }

    raster::TileGrid grid_;
    int columns_ = 0;
    std::vector<Tile> tiles_;
};

}  // namespace ink::methods
