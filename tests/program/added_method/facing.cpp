#include "methods/facing/facing.h"

namespace ink::methods {

core::ParamTable<Facing::Params> Facing::table() {
    core::ParamTable<Params> table;
    table.number(&Params::limit, "limit", {0, 1}, "", "|n . v| below which a pixel is a line.")
        .number(&Params::threshold, "threshold", {1, 255}, "", "Strength from which on it is one.");
    return add_surface_params(table);
}

void Facing::filter(const FullBufferFrame& frame,
                    const raster::Tile& tile,
                    edge::EdgeImage& out) const {
    std::array<TileFloats, 3> buffers;
    TileFloats facing;
    facing_ratio(tile, view_normals(tile, params_.renormalise, buffers), frame.rays, facing);
    for (int y = 0; y < tile.height_px; ++y) {
        const float* carried = tile.row<float>(0, y);
        std::uint8_t* to = out.row(tile.y0_px + y) + tile.x0_px;
        for (int x = 0; x < tile.width_px; ++x) {
            const bool is_line = carried[x] != kNothingDrawn &&
                                 static_cast<double>(facing.row(y)[x]) < params_.limit;
            to[x] = is_line ? 255 : 0;
        }
    }
}

MethodInfo facing() {
    MethodInfo info = method_info<Facing>("facing", "a test", "dark where n . v is small");
    info.family = Family::full_buffers;
    info.marker = Marker::cross;
    info.tunables = {{"limit", {{0.05, 0.9}}}};
    return info;
}

}  // namespace ink::methods
