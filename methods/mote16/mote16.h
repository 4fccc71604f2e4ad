#pragma once

#include "buffers/packed_buffer.h"

namespace ink::methods {

/// MOTE 1.1's 16-bit buffer of depth and normal. How its bits were laid out is lost: guesses, by
/// name.
class Mote16 : public buffers::PackedBuffer {
  public:
    enum class Layout {
        sum,          ///< four ranges added, as in mote4
        eight_eight,  ///< depth in the high byte, the normal's three components summed in the low
                      ///< one
        ten_six,      ///< 10 bits of depth, the normal's sum in 6
        four_fours,   ///< depth, x, y, z in 4 bits each, depth highest
    };
    struct Params : buffers::PackParams {
        /// Edge responses are then finer than a byte's by four.
        Params() {
            scale_bits = -6;
            // found: experiments/thresholds.py, over the training scenes at 1280x720
            threshold = 36;
        }
        Layout layout = Layout::sum;
        double range_depth = 16383;
        double range_nx = 16383;
        double range_ny = 16383;
        double range_nz = 16383;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Mote16(const Params& params);
};

[[nodiscard]] method::MethodInfo mote16();

}  // namespace ink::methods
