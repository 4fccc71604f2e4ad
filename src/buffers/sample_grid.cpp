#include "buffers/sample_grid.h"

#include <algorithm>

#include "scene/views/corner_view.h"

namespace ink::buffers {

scene::View sampled_view(const scene::View& view, Samples samples) {
    return samples == Samples::corner ? scene::corner_view(view) : view;
}

raster::Tile output_tile(const raster::Tile& tile, int width_px, int height_px) {
    raster::Tile output = tile;
    output.width_px = std::clamp(width_px - tile.x0_px, 0, tile.width_px);
    output.height_px = std::clamp(height_px - tile.y0_px, 0, tile.height_px);
    return output;
}

}  // namespace ink::buffers
