// After the single sum of Mononen's MOTE engine: two weighted sums of depth and normal, a byte
// each, with weights orthogonal to each other, so that what cancels in one seldom cancels in the
// other. Each has its Laplacian of four neighbours; the larger counts (buffers/packed_buffer.h).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "buffers/packed_buffer.h"

namespace ink::methods {
namespace {

/// Codes that depth and the normal's x, y and z span in a byte.
using Spans = std::array<double, 4>;

/// Ranges whose sum is never below 0, whatever their signs.
buffers::Ranges ranges(const Spans& spans) {
    double lowest = 0;
    for (const double span : spans)
        lowest += std::min(0.0, span);
    return {
        .depth = spans[0], .normal = {spans[1], spans[2], spans[3]}, .offset = std::ceil(-lowest)};
}

class TwoSums : public buffers::PackedBuffer {
  public:
    struct Params : buffers::PackParams {
        // found: experiments/thresholds.py, over the training scenes at 1280x720
        Params() { threshold = 18; }
        Spans first{127, 64, 64, 0};
        Spans second{0, 90, -90, 75};
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        add_spans<&Params::first>(table, "first");
        add_spans<&Params::second>(table, "second");
        return buffers::add_pack_params(table, 255);
    }
    explicit TwoSums(const Params& params) : PackedBuffer(params, layout(params)) {}

  private:
    template <Spans Params::*kByte>
    static void add_spans(core::ParamTable<Params>& table, const char* byte) {
        const auto add = [&](auto field, const char* channel, const char* meaning) {
            table.number(field,
                         fmt::format("{}_{}", byte, channel),
                         {-255, 255},
                         "code",
                         fmt::format("Codes of the {} byte that {} spans.", byte, meaning));
        };
        add(
            [](auto& of) -> auto& { return (of.*kByte)[0]; }, "depth", "depth 0..1");
        add(
            [](auto& of) -> auto& { return (of.*kByte)[1]; }, "nx", "the normal's x");
        add(
            [](auto& of) -> auto& { return (of.*kByte)[2]; }, "ny", "the normal's y");
        add(
            [](auto& of) -> auto& { return (of.*kByte)[3]; }, "nz", "the normal's z");
    }
    static buffers::CodeLayout layout(const Params& p) {
        return {.planes = 2,
                .fields = {{.ranges = ranges(p.first)}, {.ranges = ranges(p.second), .plane = 1}}};
    }
};

}  // namespace

method::MethodInfo two_sums_method() {
    return method::method_info<TwoSums>("two_sums");
}

}  // namespace ink::methods
