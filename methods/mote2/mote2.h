#pragma once

#include "buffers/packed_buffer.h"

namespace ink::methods {

/// MOTE's first buffer: depth and the normal's z in one byte, or in one byte each.
class Mote2 : public buffers::PackedBuffer {
  public:
    enum class Combine {
        sum,       ///< one code, one interpolant, one filter
        separate,  ///< two codes, two filters, joined by their maximum
    };
    struct Params : buffers::PackParams {
        Params() {
            // found: experiments/thresholds.py, over the training scenes at 1280x720
            threshold = 13;
        }
        Combine combine = Combine::sum;
        double range_depth = 127;
        double range_normal = 127;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Mote2(const Params& params);
};

[[nodiscard]] method::MethodInfo mote2();

}  // namespace ink::methods
