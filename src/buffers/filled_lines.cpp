#include "buffers/filled_lines.h"

#include "buffers/line_cost.h"

namespace ink::buffers {

/// 255 where a line is seen; lines behind fills count among what is hidden.
void FilledLinesMethod::draw(const method::Frame& frame, edge::EdgeImage& out) {
    skip_counts_ = {};
    out.fill(0);
    if (scene_.is_empty() || out.is_empty()) return;
    raster::MeshInput fills = scene_.mesh_input(frame);
    raster::LineInput lines;
    choose(frame, scene_, fills, lines);

    const scene::Camera& camera = frame.view.camera;
    depth_.start(format_.depth, camera.near, camera.far, frame.view.width_px, frame.view.height_px);
    raster::DepthSink sink(depth_);
    skip_counts_ = fills_.draw(format_, fills, sink).skips;

    lines.p_world = scene_.surface().p_world;
    lines.view = frame.view;
    lines.test = raster::LineTest::less_equal;
    lines.threads = frame.threads;
    lines.skips_hidden = frame.skips.has(raster::Skip::occlusion_culling);
    const raster::LineCounts counts = lines_.draw(lines, depth_, out);
    raster::SkipCount& hidden = raster::count_of(skip_counts_, raster::Skip::occlusion_culling);
    hidden.skipped += counts.hidden;
    hidden.of += counts.lines;
}

method::Cost FilledLinesMethod::cost() const {
    return filled_lines_cost(format_);
}

}  // namespace ink::buffers
