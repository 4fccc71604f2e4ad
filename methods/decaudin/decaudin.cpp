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

/// The rows of one channel, wherever they lie.
struct Channel {
    const float* origin;
    std::ptrdiff_t stride;

    [[nodiscard]] const float* row(int y) const { return origin + y * stride; }
};

class DecaudinSink : public raster::TileSink {
  public:
    DecaudinSink(const Decaudin::Params& params, const DepthCarrier& carrier, edge::EdgeImage& out)
        : params_(params), carrier_(carrier), out_(out) {}

    void finish(const raster::Tile& tile) override;

  private:
    [[nodiscard]] Channel depth_channel(const raster::Tile& tile, FloatBuffer& buffer) const;
    void renormalise(const raster::Tile& tile, std::array<FloatBuffer, 3>& to) const;
    void join_channel(const Channel& channel,
                      const edge::DecaudinK& k,
                      const raster::Tile& tile,
                      FloatBuffer& joined) const;
    void join(const float* p, float* joined, int count) const;
    void write(const raster::Tile& tile, FloatBuffer& joined) const;

    const Decaudin::Params& params_;
    const DepthCarrier& carrier_;
    edge::EdgeImage& out_;
};

/// The depth channel: the tile's own plane where that holds it already.
Channel DecaudinSink::depth_channel(const raster::Tile& tile, FloatBuffer& buffer) const {
    const bool near_high = params_.depth_sign == DepthSign::near_high;
    if (carrier_.is_encoded() && near_high) return {tile.row<float>(0, 0), tile.stride};
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
    return {buffer.row(0), kSpan};
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

/// Adds one channel's p to what earlier channels left; the choice stands outside the loops for
/// speed.
void DecaudinSink::join(const float* p, float* joined, int count) const {
    switch (params_.join) {
        case Decaudin::Join::max:
            for (int x = 0; x < count; ++x)
                joined[x] = std::max(joined[x], p[x]);
            return;
        case Decaudin::Join::either:
            for (int x = 0; x < count; ++x)
                joined[x] += p[x] - joined[x] * p[x];
            return;
        case Decaudin::Join::length:  // write() takes the root
            for (int x = 0; x < count; ++x)
                joined[x] += p[x] * p[x];
            return;
    }
}

void DecaudinSink::join_channel(const Channel& channel,
                                const edge::DecaudinK& k,
                                const raster::Tile& tile,
                                FloatBuffer& joined) const {
    FloatBuffer g;
    for (int y = -1; y < tile.height_px + 1; ++y) {
        edge::decaudin_g_row(channel.row(y - 1) - 1,
                             channel.row(y) - 1,
                             channel.row(y + 1) - 1,
                             g.row(y) - 1,
                             tile.width_px + 2);
    }
    std::array<float, raster::kTileSize_px> p;
    for (int y = 0; y < tile.height_px; ++y) {
        edge::decaudin_p_row(g.row(y - 1), g.row(y), g.row(y + 1), p.data(), tile.width_px, k);
        join(p.data(), joined.row(y), tile.width_px);
    }
}

void DecaudinSink::write(const raster::Tile& tile, FloatBuffer& joined) const {
    for (int y = 0; y < tile.height_px; ++y) {
        const float* from = joined.row(y);
        std::uint8_t* to = out_.row(tile.y0_px + y) + tile.x0_px;
        for (int x = 0; x < tile.width_px; ++x) {
            const float p = params_.join == Decaudin::Join::length ? std::sqrt(from[x]) : from[x];
            to[x] = static_cast<std::uint8_t>(std::min(p, 1.0F) * 255 + 0.5F);
        }
    }
}

void DecaudinSink::finish(const raster::Tile& tile) {
    if (tile.is_empty) return clear_tile(tile, out_);
    FloatBuffer depth;
    std::array<FloatBuffer, 3> normals;
    std::array<Channel, kChannels> channels;
    channels[0] = depth_channel(tile, depth);
    if (params_.renormalise) renormalise(tile, normals);
    for (std::size_t i = 0; i < 3; ++i) {
        channels[i + 1] = params_.renormalise
                              ? Channel{normals[i].row(0), kSpan}
                              : Channel{tile.row<float>(static_cast<int>(i) + 1, 0), tile.stride};
    }

    FloatBuffer joined;
    for (int y = 0; y < tile.height_px; ++y)
        std::fill_n(joined.row(y), tile.width_px, 0.0F);
    for (std::size_t i = 0; i < kChannels; ++i) {
        const double k = i == 0 ? params_.k_depth : params_.k_normal;
        join_channel(channels[i], {static_cast<float>(k), params_.k_place}, tile, joined);
    }
    write(tile, joined);
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
        // Half the bytes of the depth test.
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
