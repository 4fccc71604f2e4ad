#include "buffers/full_buffer_method.h"

#include "buffers/each_tile.h"
#include "buffers/packed_sink.h"
#include "buffers/sample_grid.h"

namespace ink::buffers {

raster::SkipCounts FullBufferMethod::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    const method::DepthCarrier carrier = pass().see(frame);
    const SurfaceInputs& inputs = pass().inputs();
    const FullBufferFrame seen{carrier, inputs.range(), PixelRays(inputs.view())};
    EachTile sink([&](const raster::Tile& tile) {
        if (tile.is_empty) return clear_tile(tile, out);
        const raster::Tile output = output_tile(tile, out.width_px(), out.height_px());
        if (output.width_px > 0 && output.height_px > 0) filter(seen, output, out);
    });
    return pass().draw(frame, carrier, sky_, sink, out);
}

method::PixelBytes encoded_depth_bytes(const InputParams& params) {
    const raster::DepthRange any_range{1, 2};
    const method::DepthCarrier carrier(params.depth_encoding, params.interpolation, any_range);
    const bool has_own_plane = carrier.is_encoded() && params.depth_sign == DepthSign::near_high;
    return has_own_plane ? method::PixelBytes{} : method::PixelBytes{4, 4};
}

method::PixelBytes view_normals_bytes(bool renormalise) {
    return renormalise ? method::PixelBytes{12, 12} : method::PixelBytes{};
}

}  // namespace ink::buffers
