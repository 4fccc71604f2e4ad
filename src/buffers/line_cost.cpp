#include "buffers/line_cost.h"

namespace ink::buffers {

method::Cost filled_lines_cost(const raster::PassFormat& format) {
    method::Cost cost;
    cost.passes = 1;
    cost.buffer_bytes_per_px = format.bytes_per_px();
    cost.fill = method::fill_work(format);
    // Depth goes from its tile to the frame, and the image is cleared.
    const double depth_bytes = format.bytes_per_px();
    cost.filter = {depth_bytes, depth_bytes + 1, 0};
    return cost;
}

}  // namespace ink::buffers
