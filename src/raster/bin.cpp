#include "raster/bin.h"

#include <algorithm>

#include "core/parallel.h"

namespace ink::raster {
namespace {

/// Whether some edge has the whole rectangle on its outer side.
bool misses(const SetupTriangle& t, const PixelRect& rect) {
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
    const int column0 = std::max(t.bounds.x0 - grid.halo_px, 0) / kTileSize_px;
    const int row0 = std::max(t.bounds.y0 - grid.halo_px, 0) / kTileSize_px;
    const int column1 =
        std::min((t.bounds.x1 - 1 + grid.halo_px) / kTileSize_px, grid.columns() - 1);
    const int row1 = std::min((t.bounds.y1 - 1 + grid.halo_px) / kTileSize_px, grid.rows() - 1);
    // A box of one row or column of tiles has no corner tiles that a triangle could miss by much.
    const bool is_wide = column1 > column0 && row1 > row0;
    for (int row = row0; row <= row1; ++row) {
        for (int column = column0; column <= column1; ++column) {
            const int tile = row * grid.columns() + column;
            if (!is_wide || !misses(t, grid.drawn(tile))) visit(static_cast<std::size_t>(tile));
        }
    }
}

}  // namespace

PixelRect TileGrid::own(int tile) const {
    const int x0 = tile % columns() * kTileSize_px;
    const int y0 = tile / columns() * kTileSize_px;
    return {x0, y0, std::min(x0 + kTileSize_px, width_px), std::min(y0 + kTileSize_px, height_px)};
}

PixelRect TileGrid::drawn(int tile) const {
    const PixelRect rect = own(tile);
    return {std::max(rect.x0 - halo_px, 0),
            std::max(rect.y0 - halo_px, 0),
            std::min(rect.x1 + halo_px, width_px),
            std::min(rect.y1 + halo_px, height_px)};
}

/// A counting sort: count per batch and tile, turn the counts into places, fill. Batches write to
/// places of their own, so the order is that of submission whatever the threads do.
Bins::Bins(const TileGrid& grid, const std::vector<Batch>& batches, int threads) {
    const auto tiles = static_cast<std::size_t>(grid.count());
    std::vector<std::size_t> places(batches.size() * tiles, 0);
    core::parallel_for(batches.size(), threads, [&](std::size_t b) {
        std::size_t* counts = places.data() + b * tiles;
        for (const SetupTriangle& t : batches[b].triangles)
            for_each_tile(grid, t, [&](std::size_t tile) { ++counts[tile]; });
    });

    first_.resize(tiles + 1);
    std::size_t place = 0;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        first_[tile] = place;
        for (std::size_t b = 0; b < batches.size(); ++b) {
            const std::size_t count = places[b * tiles + tile];
            places[b * tiles + tile] = place;
            place += count;
        }
    }
    first_[tiles] = place;

    entries_.resize(place);
    core::parallel_for(batches.size(), threads, [&](std::size_t b) {
        std::size_t* next = places.data() + b * tiles;
        std::uint32_t index = 0;
        for (const SetupTriangle& t : batches[b].triangles) {
            const BinEntry entry{static_cast<std::uint32_t>(b), index++};
            for_each_tile(grid, t, [&](std::size_t tile) { entries_[next[tile]++] = entry; });
        }
    });
}

}  // namespace ink::raster
