// Decaudin, "Cartoon-looking rendering of 3D-scenes", INRIA RR-2919, 1996: the section on outlines.
// Of each channel (depth, nx, ny, nz)
//
//     g = (|A-x| + 2|B-x| + |C-x| + 2|D-x| + 2|E-x| + |F-x| + 2|G-x| + |H-x|) / 8
//     p = min((gmax - gmin) / k, 1)^2, extremes over 3 x 3 pixels
//
// (edge/decaudin_filter.h), then one p of four.

#include <array>

#include "buffers/full_buffer_method.h"
#include "edge/decaudin_filter.h"

namespace ink::methods {
namespace {

/// Decaudin's outlines from full depth and normal buffers: the reference of the seeds' line.
class Decaudin : public buffers::FullBufferMethod {
  public:
    struct Params : buffers::InputParams {
        double k_depth = 0.02;
        double k_normal = 0.25;
        edge::KPlace k_place = edge::KPlace::inside;
        edge::DecaudinJoin join = edge::DecaudinJoin::max;
        double sky = -1;
        // found: experiments/thresholds.py, over the training scenes at 1280x720
        int threshold = 146;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table
            .number(&Params::k_depth,
                    "k_depth",
                    {1e-4, 10},
                    "",
                    "Spread of g at which a depth line is full; depth's range is 1.")
            .number(&Params::k_normal,
                    "k_normal",
                    {1e-4, 10},
                    "",
                    "Spread of g at which a normal's component makes a full line.")
            .choice(&Params::k_place,
                    "k_place",
                    {"inside", "outside"},
                    "k inside the square, (d/k)^2, or outside, d^2/k.")
            .choice(&Params::join,
                    "join",
                    {"max", "or", "length"},
                    "How the four channels' p become one.");
        return method::add_threshold(
            buffers::add_sky_depth_param(buffers::add_input_params(table)));
    }
    explicit Decaudin(const Params& params)
        : FullBufferMethod(params, 2, static_cast<float>(params.sky)), params_(params) {}

  private:
    void filter(const buffers::FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override {
        buffers::TileFloats depth_buffer;
        std::array<buffers::TileFloats, 3> normal_buffers;
        const buffers::TilePlane depth = buffers::encoded_depth(
            tile, frame.carrier, params_.depth_sign, static_cast<float>(params_.sky), depth_buffer);
        const std::array<buffers::TilePlane, 3> normals =
            buffers::view_normals(tile, params_.renormalise, normal_buffers);
        const edge::DecaudinK k_depth{static_cast<float>(params_.k_depth), params_.k_place};
        const edge::DecaudinK k_normal{static_cast<float>(params_.k_normal), params_.k_place};
        const std::array<edge::DecaudinChannel, 4> channels = {
            edge::DecaudinChannel{depth.origin, depth.stride, k_depth},
            {normals[0].origin, normals[0].stride, k_normal},
            {normals[1].origin, normals[1].stride, k_normal},
            {normals[2].origin, normals[2].stride, k_normal}};
        edge::decaudin(
            channels,
            params_.join,
            {out.row(tile.y0_px) + tile.x0_px, tile.width_px, tile.height_px, out.width_px()});
    }
    /// g of each channel is an image of its own, which p reads.
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        return buffers::encoded_depth_bytes(params_) +
               buffers::view_normals_bytes(params_.renormalise) + 4 * method::PixelBytes{4 + 4, 4} +
               method::PixelBytes{0, 1};
    }

    Params params_;
};

}  // namespace

method::MethodInfo decaudin_method() {
    return method::method_info<Decaudin>("decaudin");
}

}  // namespace ink::methods
