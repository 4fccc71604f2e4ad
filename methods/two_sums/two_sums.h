#pragma once

#include "buffers/packed_buffer.h"

namespace ink::methods {

/// Two weighted sums of depth and normal, a byte each, with weights orthogonal to each other: what
/// cancels in one seldom cancels in the other.
class TwoSums : public buffers::PackedBuffer {
  public:
    struct Params : buffers::PackParams {
        Params() {
            // found: experiments/thresholds.py, over the training scenes at 1280x720
            threshold = 18;
        }
        double first_depth = 127;
        double first_nx = 64;
        double first_ny = 64;
        double first_nz = 0;
        double second_depth = 0;
        double second_nx = 90;
        double second_ny = -90;
        double second_nz = 75;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit TwoSums(const Params& params);
};

[[nodiscard]] method::MethodInfo two_sums();

}  // namespace ink::methods
