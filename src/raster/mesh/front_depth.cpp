#include "raster/mesh/front_depth.h"

#include <algorithm>
#include <cmath>

#include "raster/mesh/lane_triangles.h"

namespace ink::raster {

void FrontDepth::start(const TileGrid& grid, const MeshInput& input) {
    grid_ = grid;
    transform_ = ViewTransform(input.view);
    near_ = input.view.camera.near;
    tiles_.resize(static_cast<std::size_t>(grid.count()));
    for (Tile& tile : tiles_)
        tile.is_drawn = false;
}

bool FrontDepth::hides(const scene::Sphere& ball) const {
    const auto seen = transform_.see(ball, near_);
    if (!seen) return false;
    // As LaneSlot::q_most has it, of anything in the ball.
    const double beyond = (seen->q_nearest - seen->q_farthest) * 0x1p-6 + seen->q_nearest * 0x1p-18;
    const auto q_most = static_cast<float>(seen->q_nearest + beyond);
    const auto& [x, y] = seen->center_px;
    const double reach_x = seen->reach_px[0] + 1;  // and what is snapped moves a part of a pixel
    const double reach_y = seen->reach_px[1] + 1;
    const auto first = [](double px) {
        return static_cast<int>(std::max(px, 0.0)) / CoarseDepth::kSquare_px;
    };
    const auto last = [](double px, int size_px) {
        return static_cast<int>(std::clamp(px, 0.0, size_px - 1.0)) / CoarseDepth::kSquare_px;
    };
    if (!(x - reach_x < grid_.width_px) || !(y - reach_y < grid_.height_px)) return false;
    const int column1 = last(x + reach_x, grid_.width_px);
    const int row1 = last(y + reach_y, grid_.height_px);
    constexpr int kSquares = CoarseDepth::kSquares;
    for (int row = first(y - reach_y); row <= row1; ++row) {
        for (int column = first(x - reach_x); column <= column1; ++column) {
            const int index = row / kSquares * grid_.columns() + column / kSquares;
            const Tile& tile = tiles_[static_cast<std::size_t>(index)];
            if (!tile.is_drawn) return false;
            const float least = tile.least[static_cast<std::size_t>(row % kSquares)]
                                          [static_cast<std::size_t>(column % kSquares)];
            if (least < q_most) return false;
        }
    }
    return true;
}

std::size_t front_clusters(const PassFormat& format,
                           const MeshInput& input,
                           const TileGrid& grid,
                           const std::vector<SolidView>& solids) {
    // Below that, tiles are drawn in two goes for too little.
    constexpr std::size_t kClustersPerTile = 8;
    const auto& clusters = input.mesh->clusters().clusters;
    const std::size_t least = kClustersPerTile * static_cast<std::size_t>(grid.count());
    const bool may_pass_over = input.skips.has(Skip::occlusion_culling) && lanes_can_draw(format) &&
                               format.depth == DepthFormat::q32 &&
                               !input.offset.is_any() &&  // what is hidden may be moved out
                               !input.may_keep_still;     // all that touches a tile is noted there
    if (!may_pass_over || clusters.size() < least) return 0;
    const auto open = std::ranges::count_if(
        clusters, [&](const auto& cluster) { return !solids[cluster.solid].hides_backs; });
    return static_cast<std::size_t>(open) < least ? 0 : clusters.size() / 2;
}

}  // namespace ink::raster
