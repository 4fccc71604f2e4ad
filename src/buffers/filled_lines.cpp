#include "buffers/filled_lines.h"

namespace ink::buffers {

/// 255 where a line is seen; lines behind fills count among what is hidden.
raster::SkipCounts FilledLinesMethod::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    out.fill(0);
    raster::MeshInput fills = pass().see(frame);
    raster::LineInput lines;
    choose(frame, pass(), fills, lines);
    raster::SkipCounts skips = pass().fill(fills);

    lines.p_world = pass().surface().p_world;
    lines.view = frame.view;
    lines.test = raster::LineTest::less_equal;
    lines.threads = frame.threads;
    lines.skips_hidden = frame.skips.has(raster::Skip::occlusion_culling);
    const raster::LineCounts counts = line_pass_.draw(lines, pass().depth(), out);
    raster::SkipCount& hidden = raster::count_of(skips, raster::Skip::occlusion_culling);
    hidden.skipped += counts.hidden;
    hidden.of += counts.lines;
    return skips;
}

}  // namespace ink::buffers
