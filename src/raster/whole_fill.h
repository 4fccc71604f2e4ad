#pragma once

#include "raster/tile_fill.h"

namespace ink::raster {

/// Draws one triangle that was set up by itself into `rect` (picture coordinates, within the tile's
/// drawn pixels), in vectors: the same bits as fill_function's plain loop.
///
/// False, and nothing done, where it has no kernel: codes run in perspective, or edges so long that
/// their steps leave 32 bits.
[[nodiscard]] bool fill_whole(const FillJob& job,
                              const BinEntry& entry,
                              const PixelRect& rect,
                              TileBuffer& buffer);

}  // namespace ink::raster
