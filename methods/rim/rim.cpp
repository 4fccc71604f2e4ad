// The facing ratio under a limit: "rim", "facing ratio" or "fresnel" outlines of shading graphs.

#include "methods/rim/rim.h"

#include <algorithm>
#include <cmath>

namespace ink::methods {
namespace {

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        {},
        // No smooth normals: whole triangles turn dark.
        {{"normals", "facet"}},
        // What the file says of its surface.
        {{"normals", "file"}},
        // Thinner, and wider.
        {{"limit", "0.1"}},
        {{"limit", "0.3"}},
        {{"limit", "0.45"}},
        // Normals exact on the surface, at the price of a division.
        {{"interpolation", "perspective"}, {"renormalise", "true"}},
        {{"interpolation", "perspective"}, {"renormalise", "true"}, {"limit", "0.15"}},
    };
}

}  // namespace

core::ParamTable<Rim::Params> Rim::table() {
    core::ParamTable<Params> table;
    table.number(&Params::limit,
                 "limit",
                 {0.01, 1},
                 "",
                 "|n.v| at which the edge response is 0; it grows to 255 where |n.v| is 0.");
    return buffers::add_surface_params(table).number(
        &Params::threshold, "threshold", {1, 255}, "", "Least edge response of a line pixel.");
}

void Rim::filter(const buffers::FullBufferFrame& frame,
                 const raster::Tile& tile,
                 edge::EdgeImage& out) const {
    std::array<buffers::TileFloats, 3> normals;
    buffers::TileFloats facing;
    buffers::facing_ratio(
        tile, buffers::view_normals(tile, params_.renormalise, normals), frame.rays, facing);
    const auto limit = static_cast<float>(params_.limit);
    for (int y = 0; y < tile.height_px; ++y) {
        const float* carried = tile.row<float>(0, y);
        const float* ratio = facing.row(y);
        std::uint8_t* to = out.row(tile.y0_px + y) + tile.x0_px;
        for (int x = 0; x < tile.width_px; ++x) {
            const float turned = 255 * (1 - std::min(ratio[x] / limit, 1.0F));
            const bool is_surface = carried[x] != method::kNothingDrawn;
            to[x] = is_surface ? static_cast<std::uint8_t>(std::lround(turned)) : 0;
        }
    }
}

method::PixelWork Rim::filter_work() const {
    constexpr double kFloat_bytes = sizeof(float);
    // n . r two products, two sums; |r| two squares, two sums, a root; a division. By the
    // limit, cut, from 1, scaled, whether there is a surface, to a byte.
    const method::PixelWork facing{
        3 * kFloat_bytes, kFloat_bytes, 4 + 1 + 4 + 2 * method::kSlowOperations};
    return buffers::view_normals_work(params_.renormalise) + facing +
           method::PixelWork{2 * kFloat_bytes, 1, 1 + 1 + 1 + 1 + 1 + 2};
}

method::MethodInfo rim() {
    method::MethodInfo info = method::method_info<Rim>(
        "rim",
        "facing ratio (rim, fresnel) outlines of shading graphs; Gooch and others 1999, section 3",
        "dark where the surface turns away from the eye, n.v under a limit");
    info.family = method::Family::full_buffers;
    info.marker = method::Marker::left;
    info.tunables = {{"limit", {{0.02, 0.8}}}};
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
