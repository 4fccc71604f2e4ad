#pragma once

#include "buffers/packed_buffer.h"

namespace ink::methods {

/// MOTE's second buffer: depth and all three components of the normal summed into one byte.
class Mote4 : public buffers::PackedBuffer {
  public:
    struct Params : buffers::PackParams {
        Params() {
            // found: experiments/thresholds.py, over the training scenes at 1280x720
            threshold = 6;
        }
        double range_depth = 63;
        double range_nx = 63;
        double range_ny = 63;
        double range_nz = 63;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Mote4(const Params& params);
};

[[nodiscard]] method::MethodInfo mote4();

}  // namespace ink::methods
