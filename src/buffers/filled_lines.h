#pragma once

#include "buffers/triangle_edges.h"
#include "method/method.h"
#include "raster/depth/depth_image.h"
#include "raster/lines/line_pass.h"
#include "raster/mesh/mesh_pass.h"

namespace ink::buffers {

/// A frame of fills and of the lines that show over them: what wireframe methods draw.
///
/// Their sources draw lines first. What is seen in the end is the nearest, and the line where both
/// are equal: under GL_LESS the fill does not replace it, and here, after the fills, the line
/// passes.
class FilledLines {
  public:
    explicit FilledLines(raster::DepthFormat depth_format) { format_.depth = depth_format; }

    [[nodiscard]] const raster::PassFormat& format() const { return format_; }

    /// Draws `fills`, which says what is culled and how it is pulled, into a depth buffer of the
    /// frame's size, and `lines`, which says which lines, how wide and how pulled, into `out`: 255
    /// where a line is seen, else as it was. View, threads and skips are the frame's, points those
    /// of `scene`. Returns what was skipped, lines behind fills with what is hidden.
    [[nodiscard]] raster::SkipCounts draw(const method::Frame& frame,
                                          const TriangleEdges& scene,
                                          const raster::MeshInput& fills,
                                          raster::LineInput lines,
                                          edge::EdgeImage& out);

  private:
    raster::PassFormat format_;
    raster::MeshPass fills_;
    raster::LinePass lines_;
    raster::DepthImage depth_;
};

}  // namespace ink::buffers
