// Decaudin, "Cartoon-looking rendering of 3D-scenes", INRIA RR-2919, 1996: the section on outlines.

#include "methods/decaudin/decaudin.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "methods/packed_sink.h"
#include "methods/surface_values.h"

namespace ink::methods {
namespace {

constexpr int kChannels = 4;  // depth, nx, ny, nz
constexpr int kSpan = raster::kTileSize_px + 2 * raster::kMaxHalo_px;

/// A tile of floats with halo; row(y)[x] in tile-local coordinates.
class FloatBuffer {
  public:
    float* row(int y) {
        return pixels_.data() + (y + raster::kMaxHalo_px) * kSpan + raster::kMaxHalo_px;
    }

  private:
    std::array<float, static_cast<std::size_t>(kSpan) * kSpan> pixels_;
};

class DecaudinSink : public raster::TileSink {
  public:
    DecaudinSink(const Decaudin::Params& params, const DepthCarrier& carrier, edge::EdgeImage& out)
        : params_(params), carrier_(carrier), out_(out) {}

    void finish(const raster::Tile& tile) override;

  private:
    [[nodiscard]] edge::DecaudinChannel depth_channel(const raster::Tile& tile,
                                                      FloatBuffer& buffer) const;
    void renormalise(const raster::Tile& tile, std::array<FloatBuffer, 3>& to) const;
    [[nodiscard]] edge::DecaudinJoin join() const;

    const Decaudin::Params& params_;
    const DepthCarrier& carrier_;
    edge::EdgeImage& out_;
};

/// The depth channel: the tile's own plane where that holds it already.
edge::DecaudinChannel DecaudinSink::depth_channel(const raster::Tile& tile,
                                                  FloatBuffer& buffer) const {
    const edge::DecaudinK k{static_cast<float>(params_.k_depth), params_.k_place};
    const bool near_high = params_.depth_sign == DepthSign::near_high;
    if (carrier_.is_encoded() && near_high) return {tile.row<float>(0, 0), tile.stride, k};
    const int halo = tile.halo_px;
    const int width = tile.width_px + 2 * halo;
    for (int y = -halo; y < tile.height_px + halo; ++y) {
        const float* carried = tile.row<float>(0, y) - halo;
        float* out = buffer.row(y) - halo;
        if (carrier_.is_encoded()) {
            std::copy_n(carried, width, out);
        } else {
            carrier_.encode_row(carried, static_cast<float>(params_.sky), out, width);
        }
        for (int x = 0; !near_high && x < width; ++x)
            out[x] = 1 - out[x];
    }
    return {buffer.row(0), kSpan, k};
}

void DecaudinSink::renormalise(const raster::Tile& tile, std::array<FloatBuffer, 3>& to) const {
    const int halo = tile.halo_px;
    for (int y = -halo; y < tile.height_px + halo; ++y) {
        for (int x = -halo; x < tile.width_px + halo; ++x) {
            float n[3];
            float square = 0;
            for (int i = 0; i < 3; ++i) {
                n[i] = tile.row<float>(i + 1, y)[x];
                square += n[i] * n[i];
            }
            const float scale = square > 0 ? 1 / std::sqrt(square) : 0;
            for (int i = 0; i < 3; ++i)
                to[static_cast<std::size_t>(i)].row(y)[x] = n[i] * scale;
        }
    }
}

edge::DecaudinJoin DecaudinSink::join() const {
    switch (params_.join) {
        case Decaudin::Join::max:
            return edge::DecaudinJoin::max;
        case Decaudin::Join::either:
            return edge::DecaudinJoin::either;
        case Decaudin::Join::length:
            break;
    }
    return edge::DecaudinJoin::length;
}

void DecaudinSink::finish(const raster::Tile& tile) {
    if (tile.is_empty) return clear_tile(tile, out_);
    FloatBuffer depth;
    std::array<FloatBuffer, 3> normals;
    std::array<edge::DecaudinChannel, kChannels> channels;
    channels[0] = depth_channel(tile, depth);
    if (params_.renormalise) renormalise(tile, normals);
    const edge::DecaudinK k_normal{static_cast<float>(params_.k_normal), params_.k_place};
    for (std::size_t i = 0; i < 3; ++i) {
        const float* plane = tile.row<float>(static_cast<int>(i) + 1, 0);
        channels[i + 1] = params_.renormalise
                              ? edge::DecaudinChannel{normals[i].row(0), kSpan, k_normal}
                              : edge::DecaudinChannel{plane, tile.stride, k_normal};
    }
    edge::decaudin(
        channels,
        join(),
        {out_.row(tile.y0_px) + tile.x0_px, tile.width_px, tile.height_px, out_.width_px()});
}

raster::PassFormat pass_format(const Decaudin::Params& params) {
    raster::PassFormat format;
    format.interpolants = kChannels;
    format.store = raster::Store::f32;
    format.interpolation = params.interpolation;
    format.depth = params.depth_format;
    format.halo_px = 2;
    return format;
}

/// From the fastest to the most exact, the method as it comes among them. Thresholds go with their
/// settings: found by ODS over the first views of the training scenes at 1280x720.
std::vector<core::ParamValues> sweep() {
    return {
        {},
        // Half the bytes of the depth test, which vector lanes do not draw yet.
        {{"depth_format", "z16"}},
        // Lines at smaller steps of depth.
        {{"k_depth", "0.01"}, {"threshold", "250"}},
        // Lines at larger steps of depth only: fewer false ones on slopes.
        {{"k_depth", "0.05"}, {"threshold", "110"}},
        // Lines at sharper creases only.
        {{"k_normal", "0.5"}, {"threshold", "187"}},
        // Both ks wide, so that strengths are told apart below the clamp.
        {{"k_normal", "0.5"}, {"k_depth", "0.05"}, {"threshold", "39"}},
        // Weak signs in several channels add up.
        {{"join", "length"}, {"k_normal", "0.5"}, {"k_depth", "0.05"}, {"threshold", "39"}},
        // The other reading of k.
        {{"k_place", "outside"}, {"threshold", "64"}},
        // No smooth normals: what adjacency buys.
        {{"normals", "facet"}},
        // Normals and depth exact on the surface, at the price of a division.
        {{"interpolation", "perspective"}},
        // The most exact input there is.
        {{"interpolation", "perspective"},
         {"renormalise", "true"},
         {"k_normal", "0.5"},
         {"threshold", "187"}},
    };
}

}  // namespace

core::ParamTable<Decaudin::Params> Decaudin::table() {
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
        .choice(
            &Params::join, "join", {"max", "or", "length"}, "How the four channels' p become one.");
    return add_input_params(table)
        .number(&Params::sky,
                "sky",
                {-1, 1},
                "depth",
                "Depth of empty pixels; -1 stands for infinity, a whole range beyond far.")
        .number(&Params::threshold,
                "threshold",
                {1, 255},
                "",
                "Strength from which on a pixel is a line.");
}

Decaudin::Decaudin(const Params& params)
    : params_(params), format_(pass_format(params)), inputs_(params) {}

void Decaudin::draw(const Frame& frame, edge::EdgeImage& out) {
    skip_counts_ = {};
    if (inputs_.is_empty()) return out.fill(0);
    inputs_.see(frame);
    const DepthCarrier carrier(params_.depth_encoding, params_.interpolation, inputs_.range());
    const ChannelValues values(inputs_, carrier);
    raster::MeshInput input = inputs_.mesh_input(frame);
    input.values = &values;
    const float sky = carrier.is_encoded() ? static_cast<float>(params_.sky) : kNothingDrawn;
    input.sky_f32 = {sky, 0, 0, 0};
    DecaudinSink sink(params_, carrier, out);
    const raster::MeshResult result = pass_.draw(format_, input, sink);
    inputs_.finish(result, out);
    skip_counts_ = result.skips;
}

MethodInfo decaudin() {
    MethodInfo info = method_info<Decaudin>(
        "decaudin",
        "Decaudin, Cartoon-looking rendering of 3D-scenes, INRIA RR-2919, 1996",
        "two nonlinear operators over full depth and normal buffers: the reference");
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
