#pragma once

#include <vector>

#include "raster/depth/coarse_depth.h"
#include "raster/mesh/mesh_pass.h"
#include "raster/mesh/mesh_view.h"
#include "raster/pass/bin.h"
#include "raster/pass/tile_buffer.h"
#include "raster/pass/view_transform.h"

namespace ink::raster {

/// What the nearest clusters of a frame leave for the others: their pixels, and how far one sees
/// past them. Kept between frames for its memory.
class FrontDepth {
  public:
    /// A tile that was drawn to.
    struct Tile {
        bool is_drawn = false;
        TilePixels pixels;
        CoarseDepth::Squares least{};
    };

    /// Knows nothing of a new frame.
    void start(const TileGrid& grid, const MeshInput& input);
    [[nodiscard]] Tile& tile(int index) { return tiles_[static_cast<std::size_t>(index)]; }
    /// Whether nothing within a ball can be seen; false where it is not known.
    [[nodiscard]] bool hides(const scene::Sphere& ball) const;

  private:
    TileGrid grid_;
    ViewTransform transform_;
    double near_ = 0;
    std::vector<Tile> tiles_;
};

/// How many of the first clusters in the order are drawn before the others are looked at; 0 where
/// that is not worth it or not allowed. Does not depend on the number of threads.
///
/// Of a solid that hides its backs, what is hidden is mostly turned away and passed over for that:
/// worth it are many clusters of surfaces that are open, or seen from inside.
[[nodiscard]] std::size_t front_clusters(const PassFormat& format,
                                         const MeshInput& input,
                                         const TileGrid& grid,
                                         const std::vector<SolidView>& solids);

}  // namespace ink::raster
