// Mononen, MOTE engine, first version (about 1998): depth and the normal's z in one byte,
//
//     code = range_depth d + range_normal (nz + 1) / 2
//
// or in one byte each, and a Laplacian of four neighbours over it (buffers/packed_buffer.h).

#include "buffers/packed_buffer.h"

namespace ink::methods {
namespace {

/// MOTE's first buffer.
class Mote2 : public buffers::PackedBuffer {
  public:
    enum class Combine {
        sum,       ///< one code, one interpolant, one filter
        separate,  ///< two codes, two filters, joined by their maximum
    };
    struct Params : buffers::PackParams {
        // found: experiments/thresholds.py, over training scenes and models at 1280x720
        Params() { threshold = 11; }
        Combine combine = Combine::sum;
        double range_depth = 127;
        double range_normal = 127;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        const std::pair<double, double> range{0, 255};
        table
            .choice(&Params::combine,
                    "combine",
                    {"sum", "separate"},
                    "Add the two into one byte, or keep and filter a byte each.")
            .number(
                &Params::range_depth, "range_depth", range, "code", "Codes that depth 0..1 spans.")
            .number(&Params::range_normal,
                    "range_normal",
                    range,
                    "code",
                    "Codes that the normal's z, -1..1, spans.");
        return buffers::add_pack_params(table, 255);
    }
    explicit Mote2(const Params& params) : PackedBuffer(params, layout(params)) {}

  private:
    static buffers::CodeLayout layout(const Params& params) {
        buffers::Ranges depth{.depth = params.range_depth};
        const buffers::Ranges normal{.normal = {0, 0, params.range_normal}};
        if (params.combine == Combine::separate) {
            return {.planes = 2, .fields = {{.ranges = depth}, {.ranges = normal, .plane = 1}}};
        }
        depth.normal = normal.normal;
        return {.planes = 1, .fields = {{.ranges = depth}}};
    }
};

}  // namespace

method::MethodInfo mote2_method() {
    return method::method_info<Mote2>("mote2");
}

}  // namespace ink::methods
