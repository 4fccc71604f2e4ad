#pragma once

#include "raster/fragments/cluster_fragments.h"
#include "raster/pass/tile_buffer.h"

namespace ink::raster {

/// Draws `count` fragments of a block in order into the tile that they were kept for.
void fill_fragments(const PassFormat& format,
                    const FragmentBlock& block,
                    std::size_t count,
                    TileBuffer& to);

}  // namespace ink::raster
