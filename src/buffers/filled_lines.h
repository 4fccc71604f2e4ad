#pragma once

#include "buffers/triangle_edges.h"
#include "method/method.h"
#include "raster/depth/depth_image.h"
#include "raster/lines/line_pass.h"
#include "raster/mesh/mesh_pass.h"

namespace ink::buffers {

/// A method that draws a wireframe and fills the triangles over it: all but which lines and fills.
///
/// The shell of polygon_offset and back_faces. Their sources draw lines first. What is seen in the
/// end is the nearest, and the line where both are equal: under GL_LESS the fill does not replace
/// it, and here, after the fills, the line passes.
class FilledLinesMethod : public method::Method {
  public:
    void prepare(const scene::Scene& scene) override { scene_.prepare(scene); }
    void pose(const scene::Scene& scene) override { scene_.pose(scene); }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    [[nodiscard]] int bytes_per_px() const override { return format_.bytes_per_px(); }
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  protected:
    FilledLinesMethod(WireEdges edges, raster::DepthFormat depth_format) : scene_(edges) {
        format_.depth = depth_format;
    }

    /// Says of `fills` what is culled and how its depth is biased, and of `lines` which, how wide
    /// and with which depth bias. View, threads, skips and points are the frame's and the scene's.
    virtual void choose(const method::Frame& frame,
                        TriangleEdges& scene,
                        raster::MeshInput& fills,
                        raster::LineInput& lines) const = 0;

  private:
    TriangleEdges scene_;
    raster::PassFormat format_;
    raster::MeshPass fills_;
    raster::LinePass lines_;
    raster::DepthImage depth_;
    raster::SkipCounts skip_counts_{};
};

}  // namespace ink::buffers
