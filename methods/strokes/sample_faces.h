#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "methods/mesh_lookup/side_lists.h"

namespace ink::methods {

/// The faces seen at the samples of a frame, by tiles, which different threads may fill.
class SampleFaces {
  public:
    void reset(int width_px, int height_px) {
        columns_ = (width_px + raster::kTileSize_px - 1) / raster::kTileSize_px;
        const int rows = (height_px + raster::kTileSize_px - 1) / raster::kTileSize_px;
        tiles_.resize(static_cast<std::size_t>(columns_ * rows));
        for (Tile& tile : tiles_)
            tile.is_sky = true;
    }
    void take(const raster::Tile& tile) {
        Tile& to = tiles_[tile_at(tile.x0_px, tile.y0_px)];
        to.is_sky = false;
        for (int y = 0; y < tile.height_px; ++y)
            std::copy_n(tile.row<std::uint32_t>(0, y), tile.width_px, to.words.data() + kSize * y);
    }
    /// At a sample of the frame; kNoNeighbour is sky.
    [[nodiscard]] std::uint32_t at(int x, int y) const {
        const Tile& tile = tiles_[tile_at(x, y)];
        if (tile.is_sky) return kNoNeighbour;
        const std::uint32_t word =
            tile.words[static_cast<std::size_t>(kSize * (y % kSize) + x % kSize)];
        return word == kNoNeighbour ? word : word & LookupWord::kFaceOfCoded;
    }

  private:
    static constexpr int kSize = raster::kTileSize_px;
    struct Tile {
        bool is_sky = true;
        std::array<std::uint32_t, std::size_t{kSize} * kSize> words;
    };

    [[nodiscard]] std::size_t tile_at(int x, int y) const {
        return static_cast<std::size_t>(y / kSize * columns_ + x / kSize);
    }

    int columns_ = 0;
    std::vector<Tile> tiles_;
};

}  // namespace ink::methods
