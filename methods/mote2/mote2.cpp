#include "methods/mote2/mote2.h"

namespace ink::methods {
namespace {

CodeLayout layout(const Mote2::Params& params) {
    const Field depth{.ranges = {.depth = params.range_depth}};
    const Field normal{.ranges = {.normal = {0, 0, params.range_normal}}, .plane = 1};
    if (params.combine == Mote2::Combine::separate) {
        return {.store = raster::Store::u8, .planes = 2, .fields = {depth, normal}};
    }
    const Field sum{.ranges = {.depth = params.range_depth, .normal = {0, 0, params.range_normal}}};
    return {.store = raster::Store::u8, .planes = 1, .fields = {sum}};
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
    return add_pack_params(table, 255);
}

Mote2::Mote2(const Params& params) : PackedBuffer(params, layout(params)) {}

MethodInfo mote2() {
    return method_info<Mote2>("mote2",
                              "Mononen, MOTE engine, first version (about 1998)",
                              "depth and normal z in one byte, 4-neighbour Laplacian");
}

}  // namespace ink::methods
