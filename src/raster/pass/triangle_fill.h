#pragma once

#include "raster/pass/tile_fill.h"

namespace ink::raster {

/// Draws one triangle that was set up by itself into a tile, in vectors: the same bits as
/// fill_function's plain loop.
///
/// False, and nothing done, where it has no kernel: codes run in perspective, or edges so long that
/// their steps leave 32 bits.
[[nodiscard]] bool fill_triangle(const FillJob& job, const BinEntry& entry, TileBuffer& buffer);

}  // namespace ink::raster
