// Decaudin, "Cartoon-looking rendering of 3D-scenes", INRIA RR-2919, 1996: the section on outlines.

#include "methods/decaudin/decaudin.h"

#include <array>

namespace ink::methods {
namespace {

edge::DecaudinJoin join_of(Decaudin::Join join) {
    switch (join) {
        case Decaudin::Join::max:
            return edge::DecaudinJoin::max;
        case Decaudin::Join::either:
            return edge::DecaudinJoin::either;
        case Decaudin::Join::length:
            break;
    }
    return edge::DecaudinJoin::length;
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
        // Both ks wide, so that edge responses are told apart below the clamp.
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
    return buffers::add_input_params(table)
        .number(&Params::sky,
                "sky",
                {-1, 1},
                "depth",
                "Depth of empty pixels; -1 stands for infinity, a whole range beyond far.")
        .number(
            &Params::threshold, "threshold", {1, 255}, "", "Least edge response of a line pixel.");
}

Decaudin::Decaudin(const Params& params)
    : buffers::FullBufferMethod(params, 2, static_cast<float>(params.sky)), params_(params) {}

void Decaudin::filter(const buffers::FullBufferFrame& frame,
                      const raster::Tile& tile,
                      edge::EdgeImage& out) const {
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
        join_of(params_.join),
        {out.row(tile.y0_px) + tile.x0_px, tile.width_px, tile.height_px, out.width_px()});
}

method::MethodInfo decaudin() {
    method::MethodInfo info = method::method_info<Decaudin>(
        "decaudin",
        "Decaudin, Cartoon-looking rendering of 3D-scenes, INRIA RR-2919, 1996",
        "two nonlinear operators over full depth and normal buffers: the reference");
    info.family = method::Family::full_buffers;
    info.marker = method::Marker::circle;
    info.tunables = {{"k_depth", {{0.001, 1}}}, {"k_normal", {{0.01, 2}}}, {"join"}, {"threshold"}};
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
