// Saito and Takahashi, "Comprehensible rendering of 3-D shapes", SIGGRAPH 1990: the section on
// discontinuities. With the neighbours A B C / D X E / F G H of pixel X
//
//     g = (|A + 2B + C - F - 2G - H| + |C + 2E + H - A - 2D - F|) / 8       (edge/sobel.h)
//     p = min((gmax - gmin) / k_first, 1)^2, extremes over 3 x 3 pixels: profiles
//     l = (8X - A - B - C - D - E - F - G - H) / 3
//     e = min(|l| / k_second, 1)^2: internal edges

#include "edge/sobel.h"

#include <algorithm>

#include "buffers/full_buffer_method.h"
#include "edge/decaudin_filter.h"

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

enum class Order {
    first,   ///< profiles alone
    second,  ///< internal edges alone
    both,    ///< the stronger of the two
};

class Sobel : public buffers::FullBufferMethod {
  public:
    struct Params : buffers::InputParams {
        Order order = Order::second;
        bool uses_normals = true;
        double sky = -1;
        // found: experiments/thresholds.py, over the training scenes at 1280x720; see the page
        double k_first = 0.02;
        double k_second = 0.02;
        double k_normal = 1;
        int threshold = 57;
    };
    static core::ParamTable<Params> table() {
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
        return method::add_threshold(
            buffers::add_sky_depth_param(buffers::add_input_params(table)));
    }
    explicit Sobel(const Params& params)
        : FullBufferMethod(params, 2, static_cast<float>(params.sky)), params_(params) {}

  private:
    void add_channel(const raster::Tile& tile,
                     const buffers::TilePlane& plane,
                     double k_first,
                     double k_second,
                     buffers::TileFloats& joined) const {
        if (params_.order != Order::second)
            join_profile(tile, plane, static_cast<float>(k_first), joined);
        if (params_.order != Order::first)
            join_internal(tile, plane, static_cast<float>(k_second), joined);
    }
    void filter(const buffers::FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override {
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
    /// g is an image of its own, which p reads; l reads the channel.
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        method::PixelBytes channel;
        if (params_.order != Order::second) channel = channel + method::PixelBytes{4 + 4, 4};
        if (params_.order != Order::first) channel = channel + method::PixelBytes{4, 0};
        return buffers::encoded_depth_bytes(params_) +
               buffers::view_normals_bytes(params_.uses_normals && params_.renormalise) +
               (params_.uses_normals ? 4 : 1) * channel + method::PixelBytes{0, 1};
    }

    Params params_;
};

}  // namespace

method::MethodInfo sobel_method() {
    return method::method_info<Sobel>("sobel");
}

}  // namespace ink::methods
