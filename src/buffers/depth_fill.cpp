#include "buffers/depth_fill.h"

namespace ink::buffers {

DepthFill::DepthFill(const InputParams& params, Reads reads)
    : SurfacePass(params, {.depth = params.depth_format}, reads) {}

raster::MeshInput DepthFill::see(const method::Frame& frame) {
    inputs().see(frame);
    raster::MeshInput input = inputs().mesh_input(frame);
    input.may_keep_still = false;
    return input;
}

raster::SkipCounts DepthFill::fill(const raster::MeshInput& input) {
    const scene::Camera& camera = input.view.camera;
    depth_.start(
        format().depth, camera.near, camera.far, input.view.width_px, input.view.height_px);
    raster::DepthSink sink(depth_);
    return draw(input, sink).skips;
}

method::Cost DepthFill::cost() const {
    method::Cost cost = SurfacePass::cost();
    const double depth = format().bytes_per_px();
    cost.filter = {depth, depth + 1};
    return cost;
}

}  // namespace ink::buffers
