#include "methods/mote4/mote4.h"

namespace ink::methods {
namespace {

CodeLayout layout(const Mote4::Params& params) {
    const Field sum{.ranges = {.depth = params.range_depth,
                               .normal = {params.range_nx, params.range_ny, params.range_nz}}};
    return {.store = raster::Store::u8, .planes = 1, .fields = {sum}};
}

}  // namespace

core::ParamTable<Mote4::Params> Mote4::table() {
    core::ParamTable<Params> table;
    const std::pair<double, double> range{0, 255};
    table.number(&Params::range_depth, "range_depth", range, "code", "Codes that depth 0..1 spans.")
        .number(&Params::range_nx, "range_nx", range, "code", "Codes that the normal's x spans.")
        .number(&Params::range_ny, "range_ny", range, "code", "Codes that the normal's y spans.")
        .number(&Params::range_nz, "range_nz", range, "code", "Codes that the normal's z spans.");
    return add_pack_params(table, 255);
}

Mote4::Mote4(const Params& params) : PackedBuffer(params, layout(params)) {}

MethodInfo mote4() {
    return method_info<Mote4>("mote4",
                              "Mononen, MOTE engine, second version (about 1998)",
                              "depth and normal x, y, z summed in one byte, 4-neighbour Laplacian");
}

}  // namespace ink::methods
