#include "methods/label8/label8.h"

namespace ink::methods {
namespace {

buffers::CodeSetup setup() {
    buffers::CodeSetup setup;
    setup.range = {.lowest = 1, .highest = 255, .least_difference = 1};  // sky is 0
    setup.gain_bits = 8;                                                 // any difference is a line
    return setup;
}

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        {{"depth_format", "z24"}},
        // Samples at pixel centres: the line lies left of or above the border.
        {{"samples", "centre"}},
        {{"samples", "centre"}, {"depth_format", "z16"}},
        // Nothing welded but what is bit-identical, and more.
        {{"weld_epsilon", "0"}},
        {{"weld_epsilon", "0.001"}},
        // Sharper and blunter creases only.
        {{"crease_deg", "20"}},
        {{"crease_deg", "60"}},
        {},
    };
}

}  // namespace

core::ParamTable<Label8::Params> Label8::table() {
    core::ParamTable<Params> table;
    return buffers::add_code_params(
        table, "Least edge response of a line pixel; it draws only 0 and 255.");
}

Label8::Label8(const Params& params) : buffers::CodeMethod(params, setup()) {}

method::MethodInfo label8() {
    method::MethodInfo info =
        method::method_info<Label8>("label8",
                                    "new here: ids of smooth patches, coloured with a byte",
                                    "a line wherever neighbours belong to patches that differ");
    info.family = method::Family::ids;
    info.marker = method::Marker::down;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
