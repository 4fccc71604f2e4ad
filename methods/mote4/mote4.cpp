#include "methods/mote4/mote4.h"

namespace ink::methods {
namespace {

buffers::CodeLayout layout(const Mote4::Params& params) {
    const buffers::Field sum{
        .ranges = {.depth = params.range_depth,
                   .normal = {params.range_nx, params.range_ny, params.range_nz}}};
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
        {{"response", "positive"}, {"threshold", "3"}},
        // Smoother and fatter, for a pass more.
        {{"fatten", "true"}, {"threshold", "3"}},
        // Half of the byte to depth: contours.
        {{"range_depth", "120"},
         {"range_nx", "45"},
         {"range_ny", "45"},
         {"range_nz", "45"},
         {"threshold", "3"}},
        // Unlike weights, so that unlike turns of the normal do not cancel.
        {{"range_depth", "75"},
         {"range_nx", "90"},
         {"range_ny", "60"},
         {"range_nz", "30"},
         {"threshold", "18"}},
        // Twice the steps, modulo 256.
        {{"overflow", "wrap"},
         {"range_depth", "127"},
         {"range_nx", "127"},
         {"range_ny", "127"},
         {"range_nz", "127"},
         {"threshold", "6"}},
        // More to depth, and more unlike.
        {{"range_depth", "100"},
         {"range_nx", "90"},
         {"range_ny", "45"},
         {"range_nz", "20"},
         {"threshold", "13"}},
        // No smooth normals: what adjacency buys.
        {{"normals", "facet"}, {"threshold", "21"}},
        // Depth and normal interpolated as floats, packed at every pixel.
        {{"packing", "pixel"}},
        // Unlike weights over exact inputs.
        {{"packing", "pixel"},
         {"interpolation", "perspective"},
         {"range_depth", "75"},
         {"range_nx", "90"},
         {"range_ny", "60"},
         {"range_nz", "30"},
         {"threshold", "18"}},
    };
}

}  // namespace

core::ParamTable<Mote4::Params> Mote4::table() {
    core::ParamTable<Params> table;
    const std::pair<double, double> range{0, 255};
    table.number(&Params::range_depth, "range_depth", range, "code", "Codes that depth 0..1 spans.")
        .number(&Params::range_nx, "range_nx", range, "code", "Codes that the normal's x spans.")
        .number(&Params::range_ny, "range_ny", range, "code", "Codes that the normal's y spans.")
        .number(&Params::range_nz, "range_nz", range, "code", "Codes that the normal's z spans.");
    return buffers::add_pack_params(table, 255);
}

Mote4::Mote4(const Params& params) : buffers::PackedBuffer(params, layout(params)) {}

method::MethodInfo mote4() {
    method::MethodInfo info = method::method_info<Mote4>(
        "mote4",
        "Mononen, MOTE engine, second version (about 1998)",
        "depth and normal x, y, z summed in one byte, 4-neighbour Laplacian");
    info.family = method::Family::packed;
    info.marker = method::Marker::square;
    info.tunables = {
        {"range_depth"}, {"range_nx"}, {"range_ny"}, {"range_nz"}, {"threshold", {{1, 64}}}};
    info.sum_limits = {{{"range_depth", "range_nx", "range_ny", "range_nz"}, 255}};
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
