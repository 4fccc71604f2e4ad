#include "methods/two_sums/two_sums.h"

#include <algorithm>
#include <cmath>

namespace ink::methods {
namespace {

/// Ranges whose sum is never below 0, whatever their signs.
buffers::Ranges ranges(double depth, const glm::dvec3& normal) {
    buffers::Ranges ranges{.depth = depth, .normal = normal};
    double lowest = std::min(0.0, depth);
    for (int i = 0; i < 3; ++i)
        lowest += std::min(0.0, normal[i]);
    ranges.offset = std::ceil(-lowest);
    return ranges;
}

buffers::CodeLayout layout(const TwoSums::Params& p) {
    const buffers::Field first{.ranges =
                                   ranges(p.first_depth, {p.first_nx, p.first_ny, p.first_nz})};
    const buffers::Field second{
        .ranges = ranges(p.second_depth, {p.second_nx, p.second_ny, p.second_nz}), .plane = 1};
    return {.store = raster::Store::u8, .planes = 2, .fields = {first, second}};
}

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        {},
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        // One pixel wide instead of two: less to thin.
        {{"response", "positive"}},
        // Smoother and fatter, for a pass more.
        {{"fatten", "true"}, {"threshold", "12"}},
        // Fewer lines, of the strongest steps.
        {{"threshold", "36"}},
        // More lines, and speckle on curved surfaces.
        {{"threshold", "10"}},
        // Depth alone in one byte, the normal alone in the other: nothing of depth cancels.
        {{"first_depth", "255"},
         {"first_nx", "0"},
         {"first_ny", "0"},
         {"second_nx", "64"},
         {"second_ny", "127"},
         {"second_nz", "64"}},
        // Twice the steps, modulo 256.
        {{"overflow", "wrap"},
         {"first_depth", "254"},
         {"first_nx", "128"},
         {"first_ny", "128"},
         {"second_nx", "180"},
         {"second_ny", "-180"},
         {"second_nz", "150"},
         {"threshold", "58"}},
        // Depth and normal interpolated as floats, packed at every pixel.
        {{"packing", "pixel"}},
        {{"packing", "pixel"}, {"interpolation", "perspective"}},
    };
}

}  // namespace

core::ParamTable<TwoSums::Params> TwoSums::table() {
    core::ParamTable<Params> table;
    const std::pair<double, double> range{-255, 255};
    const auto add = [&](double Params::*field, const char* name, const char* what) {
        table.number(field, name, range, "code", what);
    };
    add(&Params::first_depth, "first_depth", "Codes of the first byte that depth 0..1 spans.");
    add(&Params::first_nx, "first_nx", "Codes of the first byte that the normal's x spans.");
    add(&Params::first_ny, "first_ny", "Codes of the first byte that the normal's y spans.");
    add(&Params::first_nz, "first_nz", "Codes of the first byte that the normal's z spans.");
    add(&Params::second_depth, "second_depth", "Codes of the second byte that depth 0..1 spans.");
    add(&Params::second_nx, "second_nx", "Codes of the second byte that the normal's x spans.");
    add(&Params::second_ny, "second_ny", "Codes of the second byte that the normal's y spans.");
    add(&Params::second_nz, "second_nz", "Codes of the second byte that the normal's z spans.");
    return buffers::add_pack_params(table, 255);
}

TwoSums::TwoSums(const Params& params) : buffers::PackedBuffer(params, layout(params)) {}

method::MethodInfo two_sums() {
    method::MethodInfo info = method::method_info<TwoSums>(
        "two_sums",
        "this project; after the single sum of Mononen, MOTE engine",
        "two weighted sums of depth and normal in two bytes, 4-neighbour Laplacian");
    info.family = method::Family::packed;
    info.marker = method::Marker::left;
    info.tunables = {{"first_depth", {{0, 255}}},
                     {"first_nx", {{0, 255}}},
                     {"first_ny", {{0, 255}}},
                     {"first_nz", {{0, 255}}},
                     {"second_depth"},
                     {"second_nx", {{0, 255}}},
                     {"second_ny"},
                     {"second_nz"},
                     {"threshold", {{1, 64}}}};
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
