#pragma once

#include <algorithm>

#include "core/param.h"
#include "raster/pass/pass.h"
#include "scene/camera.h"

namespace ink::buffers {

/// Where a pass takes its one sample a pixel.
enum class Samples {
    centre,  ///< at the pixel's centre; a line runs between two pixels, and lies in either
    corner,  ///< at pixel corners, one row and column more; a line lies in the pixel it runs in
};

/// Appends the row `samples` to a table whose struct has such a member.
template <class P>
core::ParamTable<P>& add_samples_param(core::ParamTable<P>& table) {
    return table.choice(&P::samples,
                        "samples",
                        {"centre", "corner"},
                        "Where surfaces are sampled: at pixel centres, or at pixel corners, where "
                        "a pixel is a line if its four do not belong together.");
}

/// The view that a pass has to draw: `view`, or scene::corner_view() of it.
[[nodiscard]] inline scene::View sampled_view(const scene::View& view, Samples samples) {
    return samples == Samples::corner ? scene::corner_view(view) : view;
}

/// A tile without what lies beyond an image of width_px x height_px; its size may become 0.
///
/// In a corner pass sample (x, y) is the upper left corner of pixel (x, y): a tile writes the
/// pixels whose upper left corners it owns, from its samples (x, y) to (x + 1, y + 1), hence needs
/// a halo of 1 px. The last row and column of samples have no pixel. In a pass over centres the
/// tile comes back as it is.
[[nodiscard]] inline raster::Tile output_tile(raster::Tile tile, int width_px, int height_px) {
    tile.width_px = std::clamp(width_px - tile.x0_px, 0, tile.width_px);
    tile.height_px = std::clamp(height_px - tile.y0_px, 0, tile.height_px);
    return tile;
}

}  // namespace ink::buffers
