#include "methods/mote16/mote16.h"

namespace ink::methods {
namespace {

buffers::Field depth_field(int bits) {
    return {.ranges = {.depth = static_cast<double>((1 << bits) - 1)},
            .shift = 16 - bits,
            .bits = bits};
}

/// The three components summed in the lowest `bits`, a third of the range each.
buffers::Field normal_field(int bits) {
    const double third = static_cast<double>((1 << bits) - 1) / 3;
    return {.ranges = {.normal = {third, third, third}}, .shift = 0, .bits = bits};
}

buffers::Field component_field(int component, int shift) {
    buffers::Field field;
    field.shift = shift;
    field.bits = 4;
    field.ranges.normal[component] = 15;
    return field;
}

std::vector<buffers::Field> fields(const Mote16::Params& params) {
    switch (params.layout) {
        case Mote16::Layout::eight_eight:
            return {depth_field(8), normal_field(8)};
        case Mote16::Layout::ten_six:
            return {depth_field(10), normal_field(6)};
        case Mote16::Layout::four_fours:
            return {depth_field(4),
                    component_field(0, 8),
                    component_field(1, 4),
                    component_field(2, 0)};
        case Mote16::Layout::sum:
            break;
    }
    return {{.ranges = {.depth = params.range_depth,
                        .normal = {params.range_nx, params.range_ny, params.range_nz}},
             .bits = 16}};
}

/// From the fastest to the most exact, the method as it comes among them. Thresholds go with their
/// settings: found by ODS over the first views of the training scenes at 1280x720.
std::vector<core::ParamValues> sweep() {
    return {
        {},
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        // One pixel wide instead of two: less to thin.
        {{"response", "positive"}, {"threshold", "16"}},
        // Smoother and fatter, for a pass more.
        {{"fatten", "true"}, {"threshold", "3"}},
        // Unlike weights, so that unlike turns of the normal do not cancel.
        {{"range_depth", "19200"},
         {"range_nx", "23000"},
         {"range_ny", "15300"},
         {"range_nz", "7700"},
         {"threshold", "82"}},
        // Twice the steps, modulo 65536.
        {{"overflow", "wrap"},
         {"range_depth", "32767"},
         {"range_nx", "32767"},
         {"range_ny", "32767"},
         {"range_nz", "32767"},
         {"threshold", "34"}},
        // A byte of depth, a byte of normal. Packed at pixels: between vertices, what one field
        // overflows spoils the next.
        {{"layout", "8+8"}, {"packing", "pixel"}, {"scale_bits", "0"}, {"threshold", "3"}},
        // Four bits each: the coarsest of the guesses.
        {{"layout", "4x4"}, {"packing", "pixel"}, {"scale_bits", "0"}, {"threshold", "3"}},
        // Depth and normal interpolated as floats, packed at every pixel.
        {{"packing", "pixel"}},
        // Unlike weights over exact inputs.
        {{"packing", "pixel"},
         {"interpolation", "perspective"},
         {"range_depth", "19200"},
         {"range_nx", "23000"},
         {"range_ny", "15300"},
         {"range_nz", "7700"},
         {"threshold", "82"}},
    };
}

}  // namespace

core::ParamTable<Mote16::Params> Mote16::table() {
    core::ParamTable<Params> table;
    const std::pair<double, double> range{0, 65535};
    table
        .choice(&Params::layout,
                "layout",
                {"sum", "8+8", "10+6", "4x4"},
                "How the 16 bits are divided: guesses, the original is lost.")
        .number(&Params::range_depth,
                "range_depth",
                range,
                "code",
                "Codes that depth 0..1 spans (layout = sum).")
        .number(&Params::range_nx,
                "range_nx",
                range,
                "code",
                "Codes that the normal's x spans (layout = sum).")
        .number(&Params::range_ny,
                "range_ny",
                range,
                "code",
                "Codes that the normal's y spans (layout = sum).")
        .number(&Params::range_nz,
                "range_nz",
                range,
                "code",
                "Codes that the normal's z spans (layout = sum).");
    return buffers::add_pack_params(table, 65535);
}

Mote16::Mote16(const Params& params)
    : buffers::PackedBuffer(params,
                            {.store = raster::Store::u16, .planes = 1, .fields = fields(params)}) {}

method::MethodInfo mote16() {
    method::MethodInfo info =
        method::method_info<Mote16>("mote16",
                                    "Mononen, MOTE engine 1.1 (about 1999); bit layout guessed",
                                    "depth and normal in 16 bits, 4-neighbour Laplacian");
    info.family = method::Family::packed;
    info.marker = method::Marker::diamond;
    info.tunables = {{"range_depth"}, {"range_nx"}, {"range_ny"}, {"range_nz"}, {"threshold"}};
    info.sum_limits = {{{"range_depth", "range_nx", "range_ny", "range_nz"}, 65535}};
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
