#include "buffers/filled_lines.h"

namespace ink::buffers {

raster::SkipCounts FilledLines::draw(const method::Frame& frame,
                                     const TriangleEdges& scene,
                                     const raster::MeshInput& fills,
                                     raster::LineInput lines,
                                     edge::EdgeImage& out) {
    const scene::Camera& camera = frame.view.camera;
    depth_.start(format_.depth, camera.near, camera.far, frame.view.width_px, frame.view.height_px);
    raster::DepthSink sink(depth_);
    raster::SkipCounts skips = fills_.draw(format_, fills, sink).skips;

    lines.p_world = scene.surface().p_world;
    lines.view = frame.view;
    lines.test = raster::LineTest::less_equal;
    lines.threads = frame.threads;
    lines.skips_hidden = frame.skips.has(raster::Skip::hidden);
    const raster::LineCounts counts = lines_.draw(lines, depth_, out);
    raster::SkipCount& hidden = raster::count_of(skips, raster::Skip::hidden);
    hidden.skipped += counts.hidden;
    hidden.of += counts.lines;
    return skips;
}

}  // namespace ink::buffers
