#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "methods/grey_lines/sample_tiles.h"
#include "methods/mesh_lookup/side_lists.h"

namespace ink::methods {

/// The faces seen at the samples of a frame.
class SampleFaces {
  public:
    void reset(const raster::TileGrid& grid) { tiles_.reset(grid); }
    void take(const raster::Tile& tile) {
        Tile& to = tiles_.of(tile.x0_px, tile.y0_px);
        to.is_sky = false;
        for (int y = 0; y < tile.height_px; ++y)
            std::copy_n(
                tile.row<std::uint32_t>(0, y), tile.width_px, to.words.data() + Tiles::place(0, y));
    }
    /// At a sample of the frame; kNoNeighbour is sky.
    [[nodiscard]] std::uint32_t at(int x, int y) const {
        const Tile& tile = tiles_.of(x, y);
        if (tile.is_sky) return kNoNeighbour;
        const std::uint32_t word = tile.words[Tiles::place(x, y)];
        return word == kNoNeighbour ? word : word & LookupWord::kFaceOfCoded;
    }

  private:
    struct Tile;
    using Tiles = SampleTiles<Tile>;
    struct Tile {
        bool is_sky = true;
        std::array<std::uint32_t, Tiles::kCount> words;

        void clear() { is_sky = true; }
    };

    Tiles tiles_;
};

}  // namespace ink::methods
