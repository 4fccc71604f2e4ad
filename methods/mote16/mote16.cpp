// Mononen, MOTE engine 1.1 (about 1999): depth and normal in 16 bits, and a Laplacian of four
// neighbours over them (buffers/packed_buffer.h). How the bits were laid out is lost: guesses, by
// name.

#include "buffers/packed_buffer.h"

namespace ink::methods {
namespace {

enum class Layout {
    sum,          ///< four ranges added, as in mote4
    eight_eight,  ///< depth in the high byte, the normal's three components summed in the low one
    ten_six,      ///< 10 bits of depth, the normal's sum in 6
    four_fours,   ///< depth, x, y, z in 4 bits each, depth highest
};

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
    buffers::Field field{.ranges = {}, .shift = shift, .bits = 4};
    field.ranges.normal[component] = 15;
    return field;
}

std::vector<buffers::Field> fields(Layout layout, const buffers::SumParams& sum) {
    switch (layout) {
        case Layout::eight_eight:
            return {depth_field(8), normal_field(8)};
        case Layout::ten_six:
            return {depth_field(10), normal_field(6)};
        case Layout::four_fours:
            return {depth_field(4),
                    component_field(0, 8),
                    component_field(1, 4),
                    component_field(2, 0)};
        case Layout::sum:
            break;
    }
    return {{.ranges = sum.ranges(), .bits = 16}};
}

/// MOTE's third buffer.
class Mote16 : public buffers::PackedBuffer {
  public:
    struct Params : buffers::PackParams, buffers::SumParams {
        Params() : SumParams{16383, 16383, 16383, 16383} {
            scale_bits = -6;  // edge responses are then finer than a byte's by four
            // found: experiments/thresholds.py, over the training scenes at 1280x720
            threshold = 36;
        }
        Layout layout = Layout::sum;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table.choice(&Params::layout,
                     "layout",
                     {"sum", "8+8", "10+6", "4x4"},
                     "How the 16 bits are divided: guesses, the original is lost.");
        buffers::add_sum_params(table, 65535, " (layout = sum).");
        return buffers::add_pack_params(table, 65535);
    }
    explicit Mote16(const Params& params)
        : PackedBuffer(
              params,
              {.store = raster::Store::u16, .planes = 1, .fields = fields(params.layout, params)}) {
    }
};

}  // namespace

method::MethodInfo mote16_method() {
    return method::method_info<Mote16>("mote16");
}

}  // namespace ink::methods
