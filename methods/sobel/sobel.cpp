// Saito and Takahashi, "Comprehensible rendering of 3-D shapes", SIGGRAPH 1990: the section on
// discontinuities.

#include "methods/sobel/sobel.h"

#include <algorithm>

#include "edge/decaudin_filter.h"
#include "edge/sobel.h"

namespace ink::methods {
namespace {

/// Joins the profile p = min((gmax - gmin) / k, 1)^2 of one plane, extremes over 3 x 3 pixels, by
/// the larger. Saito and Takahashi's p is Decaudin's of another g.
void join_profile(const raster::Tile& tile,
                  const buffers::TilePlane& plane,
                  float k,
                  buffers::TileFloats& joined) {
    buffers::TileFloats g;
    const core::ImageView<const float> from{
        plane.row(-1) - 1, tile.width_px + 2, tile.height_px + 2, plane.stride};
    const core::ImageView<float> to{
        g.row(-1) - 1, tile.width_px + 2, tile.height_px + 2, buffers::TileFloats::kSpan};
    edge::sobel(from, edge::Differential::first, to);
    std::array<float, raster::kTileSize_px> p;
    for (int y = 0; y < tile.height_px; ++y) {
        edge::decaudin_p_row(
            g.row(y - 1), g.row(y), g.row(y + 1), p.data(), tile.width_px, {.k = k});
        float* row = joined.row(y);
        for (int x = 0; x < tile.width_px; ++x)
            row[x] = std::max(row[x], p[static_cast<std::size_t>(x)]);
    }
}

/// The same with the internal edge e = min(|l| / k, 1)^2.
void join_internal(const raster::Tile& tile,
                   const buffers::TilePlane& plane,
                   float k,
                   buffers::TileFloats& joined) {
    buffers::TileFloats l;
    const core::ImageView<const float> from{
        plane.row(0), tile.width_px, tile.height_px, plane.stride};
    const core::ImageView<float> to{
        l.row(0), tile.width_px, tile.height_px, buffers::TileFloats::kSpan};
    edge::sobel(from, edge::Differential::second, to);
    for (int y = 0; y < tile.height_px; ++y) {
        const float* edge_response = l.row(y);
        float* row = joined.row(y);
        for (int x = 0; x < tile.width_px; ++x) {
            const float e = std::min(edge_response[x] / k, 1.0F);
            row[x] = std::max(row[x], e * e);
        }
    }
}

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        {},
        // Depth alone: what the paper's own images are made of.
        {{"uses_normals", "false"}},
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        // Lines at smaller steps and bends of depth.
        {{"k_second", "0.005"}},
        // Lines at larger ones only.
        {{"k_second", "0.05"}},
        // Profiles: wide lines where depth jumps, and where the normal does.
        {{"order", "first"}, {"threshold", "31"}},
        // Both kinds of line.
        {{"order", "both"}, {"threshold", "161"}},
        // No smooth normals: what adjacency buys.
        {{"normals", "facet"}},
        // The most exact input there is.
        {{"interpolation", "perspective"}, {"renormalise", "true"}},
    };
}

}  // namespace

core::ParamTable<Sobel::Params> Sobel::table() {
    core::ParamTable<Params> table;
    table
        .choice(&Params::order,
                "order",
                {"first", "second", "both"},
                "Profiles, internal edges, or the stronger of the two.")
        .flag(&Params::uses_normals,
              "uses_normals",
              "Run the same operators over the normal's components too.")
        .number(&Params::k_first,
                "k_first",
                {1e-5, 10},
                "",
                "Spread of g at which a profile is full; depth's range is 1.")
        .number(&Params::k_second,
                "k_second",
                {1e-5, 10},
                "",
                "Second differential at which an internal edge is full; depth's range is 1.")
        .number(&Params::k_normal,
                "k_normal",
                {1e-3, 10},
                "",
                "Value of either at which a component of the normal makes a full line.");
    return buffers::add_input_params(table)
        .number(&Params::sky,
                "sky",
                {-1, 1},
                "depth",
                "Depth of empty pixels; -1 stands for infinity, a whole range beyond far.")
        .number(
            &Params::threshold, "threshold", {1, 255}, "", "Least edge response of a line pixel.");
}

Sobel::Sobel(const Params& params)
    : buffers::FullBufferMethod(params, 2, static_cast<float>(params.sky)), params_(params) {}

void Sobel::add_channel(const raster::Tile& tile,
                        const buffers::TilePlane& plane,
                        double k_first,
                        double k_second,
                        buffers::TileFloats& joined) const {
    if (params_.order != Order::second)
        join_profile(tile, plane, static_cast<float>(k_first), joined);
    if (params_.order != Order::first)
        join_internal(tile, plane, static_cast<float>(k_second), joined);
}

void Sobel::filter(const buffers::FullBufferFrame& frame,
                   const raster::Tile& tile,
                   edge::EdgeImage& out) const {
    buffers::TileFloats depth_buffer;
    std::array<buffers::TileFloats, 3> normal_buffers;
    buffers::TileFloats joined;
    for (int y = 0; y < tile.height_px; ++y)
        std::fill_n(joined.row(y), tile.width_px, 0.0F);
    const buffers::TilePlane depth = buffers::encoded_depth(
        tile, frame.carrier, params_.depth_sign, static_cast<float>(params_.sky), depth_buffer);
    add_channel(tile, depth, params_.k_first, params_.k_second, joined);
    if (params_.uses_normals) {
        for (const buffers::TilePlane& normal :
             buffers::view_normals(tile, params_.renormalise, normal_buffers))
            add_channel(tile, normal, params_.k_normal, params_.k_normal, joined);
    }
    for (int y = 0; y < tile.height_px; ++y) {
        std::uint8_t* to = out.row(tile.y0_px + y) + tile.x0_px;
        const float* row = joined.row(y);
        for (int x = 0; x < tile.width_px; ++x)
            to[x] = static_cast<std::uint8_t>(row[x] * 255 + 0.5F);
    }
}

method::PixelWork Sobel::filter_work() const {
    constexpr double kFloat_bytes = sizeof(float);
    method::PixelWork channel;
    if (params_.order != Order::second) {
        // g: four sums of three with the middle doubled, two differences and sizes, a sum, over 8;
        // an image of its own. p: extremes of columns and rows, difference, over k, squared, cut.
        channel = channel + method::PixelWork{kFloat_bytes, kFloat_bytes, 4 * 3 + 4 + 1 + 1};
        channel = channel + method::PixelWork{kFloat_bytes, 0, 2 * (2 + 2) + 4 + 1};
    }
    if (params_.order != Order::first) {
        // Eight times the middle, less eight; its size, over 3 and over k, cut, squared, joined.
        channel = channel +
                  method::PixelWork{kFloat_bytes, 0, 1 + 8 + 1 + 2 * method::kSlowOperations + 3};
    }
    const method::PixelWork write{0, 1, 3};
    return buffers::encoded_depth_work(params_) +
           buffers::view_normals_work(params_.uses_normals && params_.renormalise) +
           (params_.uses_normals ? 4.0 : 1.0) * channel + write;
}

method::MethodInfo sobel() {
    method::MethodInfo info = method::method_info<Sobel>(
        "sobel",
        "Saito and Takahashi, Comprehensible rendering of 3-D shapes, SIGGRAPH 1990",
        "first and second differentials of depth: profiles and internal edges");
    info.family = method::Family::full_buffers;
    info.marker = method::Marker::diamond;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
