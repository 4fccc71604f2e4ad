// Mononen, MOTE engine, second version (about 1998): depth and the normal in one byte,
//
//     code = range_depth d + range_nx (nx + 1) / 2 + range_ny (ny + 1) / 2 + range_nz (nz + 1) / 2
//
// and a Laplacian of four neighbours over it (buffers/packed_buffer.h).

#include "buffers/packed_buffer.h"

namespace ink::methods {
namespace {

/// MOTE's second buffer: depth and all three components of the normal summed into one byte.
class Mote4 : public buffers::PackedBuffer {
  public:
    struct Params : buffers::PackParams, buffers::SumParams {
        // found: experiments/thresholds.py, over the training scenes at 1280x720
        Params() { threshold = 6; }
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        return buffers::add_pack_params(buffers::add_sum_params(table, 255), 255);
    }
    explicit Mote4(const Params& params)
        : PackedBuffer(
              params,
              {.store = raster::Store::u8, .planes = 1, .fields = {{.ranges = params.ranges()}}}) {}
};

}  // namespace

method::MethodInfo mote4_method() {
    return method::method_info<Mote4>("mote4");
}

}  // namespace ink::methods
