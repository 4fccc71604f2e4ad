// After the single sum of Mononen's MOTE engine: two weighted sums of depth and normal, a byte
// each, with weights orthogonal to each other, so that what cancels in one seldom cancels in the
// other. Each has its Laplacian of four neighbours; the larger counts (buffers/packed_buffer.h).

#include <algorithm>
#include <cmath>

#include "buffers/packed_buffer.h"

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

class TwoSums : public buffers::PackedBuffer {
  public:
    struct Params : buffers::PackParams {
        // found: experiments/thresholds.py, over the training scenes at 1280x720
        Params() { threshold = 18; }
        double first_depth = 127;
        double first_nx = 64;
        double first_ny = 64;
        double first_nz = 0;
        double second_depth = 0;
        double second_nx = 90;
        double second_ny = -90;
        double second_nz = 75;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        const auto add = [&](double Params::*field, const char* name, const char* what) {
            table.number(field, name, {-255, 255}, "code", std::string("Codes of the ") + what);
        };
        add(&Params::first_depth, "first_depth", "first byte that depth 0..1 spans.");
        add(&Params::first_nx, "first_nx", "first byte that the normal's x spans.");
        add(&Params::first_ny, "first_ny", "first byte that the normal's y spans.");
        add(&Params::first_nz, "first_nz", "first byte that the normal's z spans.");
        add(&Params::second_depth, "second_depth", "second byte that depth 0..1 spans.");
        add(&Params::second_nx, "second_nx", "second byte that the normal's x spans.");
        add(&Params::second_ny, "second_ny", "second byte that the normal's y spans.");
        add(&Params::second_nz, "second_nz", "second byte that the normal's z spans.");
        return buffers::add_pack_params(table, 255);
    }
    explicit TwoSums(const Params& params) : PackedBuffer(params, layout(params)) {}

  private:
    static buffers::CodeLayout layout(const Params& p) {
        const auto first = ranges(p.first_depth, {p.first_nx, p.first_ny, p.first_nz});
        const auto second = ranges(p.second_depth, {p.second_nx, p.second_ny, p.second_nz});
        return {.planes = 2, .fields = {{.ranges = first}, {.ranges = second, .plane = 1}}};
    }
};

}  // namespace

method::MethodInfo two_sums_method() {
    return method::method_info<TwoSums>("two_sums");
}

}  // namespace ink::methods
