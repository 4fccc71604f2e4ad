#include "methods/facing/facing.h"

namespace ink::methods {

core::ParamTable<Facing::Params> Facing::table() {
    core::ParamTable<Params> table;
    table.number(&Params::limit, "limit", {0, 1}, "", "|n . v| below which a pixel is a line.")
        .number(&Params::threshold,
                "threshold",
                {1, 255},
                "",
                "Edge response from which on it is one.");
    return buffers::add_surface_params(table);
}

void Facing::filter(const buffers::FullBufferFrame& frame,
                    const raster::Tile& tile,
                    edge::EdgeImage& out) const {
    std::array<buffers::TileFloats, 3> scratch;
    buffers::TileFloats facing;
    buffers::facing_ratio(
        tile, buffers::view_normals(tile, params_.renormalise, scratch), frame.rays, facing);
    for (int y = 0; y < tile.height_px; ++y) {
        const float* carried = tile.row<float>(0, y);
        std::uint8_t* to = out.row(tile.y0_px + y) + tile.x0_px;
        for (int x = 0; x < tile.width_px; ++x) {
            const bool is_line = carried[x] != method::kNothingDrawn &&
                                 static_cast<double>(facing.row(y)[x]) < params_.limit;
            to[x] = is_line ? 255 : 0;
        }
    }
}

method::MethodInfo facing() {
    method::MethodInfo info =
        method::method_info<Facing>("facing", "a test", "dark where n . v is small");
    info.family = method::Family::full_buffers;
    info.marker = method::Marker::cross;
    info.tunables = {{"limit", {{0.05, 0.9}}}};
    return info;
}

}  // namespace ink::methods
