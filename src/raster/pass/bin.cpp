#include "raster/pass/bin.h"

#include "core/parallel.h"

namespace ink::raster {
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
