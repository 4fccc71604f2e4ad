#include "methods/mote2/mote2.h"

namespace ink::methods {
namespace {

buffers::CodeLayout layout(const Mote2::Params& params) {
    const buffers::Field depth{.ranges = {.depth = params.range_depth}};
    const buffers::Field normal{.ranges = {.normal = {0, 0, params.range_normal}}, .plane = 1};
    if (params.combine == Mote2::Combine::separate) {
        return {.store = raster::Store::u8, .planes = 2, .fields = {depth, normal}};
    }
    const buffers::Field sum{
        .ranges = {.depth = params.range_depth, .normal = {0, 0, params.range_normal}}};
    return {.store = raster::Store::u8, .planes = 1, .fields = {sum}};
}

/// From the fastest to the most exact, the method as it comes among them. Thresholds go with their
/// settings: found by ODS over the first views of the training scenes at 1280x720.
std::vector<core::ParamValues> sweep() {
    return {
        {},
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        // One pixel wide instead of two: less to thin.
        {{"response", "positive"}},
        // Smoother and fatter, for a pass more.
        {{"fatten", "true"}, {"threshold", "6"}},
        // Most of the byte to depth: contours.
        {{"range_depth", "191"}, {"range_normal", "64"}, {"threshold", "6"}},
        // Most of the byte to the normal: creases.
        {{"range_depth", "64"}, {"range_normal", "191"}, {"threshold", "26"}},
        // Twice the steps, modulo 256.
        {{"overflow", "wrap"},
         {"range_depth", "255"},
         {"range_normal", "255"},
         {"threshold", "11"}},
        // A byte and a filter each: nothing cancels.
        {{"combine", "separate"}, {"threshold", "21"}},
        // Each with all of its byte.
        {{"combine", "separate"},
         {"range_depth", "255"},
         {"range_normal", "255"},
         {"threshold", "46"}},
        // Depth and normal interpolated as floats, packed at every pixel.
        {{"packing", "pixel"}},
        // All of it: the most exact two bytes can be.
        {{"packing", "pixel"},
         {"combine", "separate"},
         {"interpolation", "perspective"},
         {"range_depth", "255"},
         {"range_normal", "255"},
         {"threshold", "46"}},
    };
}

}  // namespace

core::ParamTable<Mote2::Params> Mote2::table() {
    core::ParamTable<Params> table;
    table
        .choice(&Params::combine,
                "combine",
                {"sum", "separate"},
                "Add the two into one byte, or keep and filter a byte each.")
        .number(
            &Params::range_depth, "range_depth", {0, 255}, "code", "Codes that depth 0..1 spans.")
        .number(&Params::range_normal,
                "range_normal",
                {0, 255},
                "code",
                "Codes that the normal's z, -1..1, spans.");
    return buffers::add_pack_params(table, 255);
}

Mote2::Mote2(const Params& params) : buffers::PackedBuffer(params, layout(params)) {}

method::MethodInfo mote2() {
    method::MethodInfo info =
        method::method_info<Mote2>("mote2",
                                   "Mononen, MOTE engine, first version (about 1998)",
                                   "depth and normal z in one byte, 4-neighbour Laplacian");
    info.family = method::Family::packed;
    info.marker = method::Marker::circle;
    info.tunables = {{"range_depth"}, {"range_normal"}, {"threshold", {{1, 64}}}};
    info.sum_limits = {{{"range_depth", "range_normal"}, 255}};
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
