#pragma once

#include "buffers/surface_method.h"
#include "buffers/triangle_edges.h"

namespace ink::buffers {

/// The parameters that wireframes under fills share.
struct WireParams {
    double width_px = 2;
    double units = 0;
    WireEdges edges = WireEdges::all;
    raster::DepthFormat depth_format = raster::DepthFormat::z24;
    int threshold = 128;  ///< 0 and 255 alone are drawn
};

/// Appends the rows `width_px`, and `edges`.
template <class P>
core::ParamTable<P>& add_wire_width_param(core::ParamTable<P>& table) {
    return table.number(
        &P::width_px,
        "width_px",
        {1, 16},
        "px",
        "Width of the wireframe's lines, to the nearest px; half of it is visible.");
}
template <class P>
core::ParamTable<P>& add_wire_edges_param(core::ParamTable<P>& table) {
    return table.choice(&P::edges,
                        "edges",
                        {"all", "polygons"},
                        "Edges of all triangles, or without those inside a flat polygon.");
}

/// Appends the rows `depth_format`, of a buffer that decides what is seen, and `threshold`.
template <class P>
core::ParamTable<P>& add_depth_buffer_params(core::ParamTable<P>& table) {
    return method::add_threshold(add_depth_format_param(
        table, "Format of the depth buffer: float 1/w, or whole steps of window depth."));
}

/// A method that draws a wireframe and fills the triangles over it: all but which lines and fills.
///
/// The shell of polygon_offset and back_faces. Their sources draw lines first. What is seen in the
/// end is the nearest, and the line where both are equal: under GL_LESS the fill does not replace
/// it, and here, after the fills, the line passes.
class FilledLinesMethod : public SurfaceMethod<TriangleEdges> {
  protected:
    explicit FilledLinesMethod(const WireParams& params)
        : SurfaceMethod(params.edges, params.depth_format) {}

    /// Says of `fills` what is culled and how its depth is biased, and of `lines` which, how wide
    /// and with which depth bias. View, threads, skips and points are the frame's and the scene's.
    virtual void choose(const method::Frame& frame,
                        TriangleEdges& scene,
                        raster::MeshInput& fills,
                        raster::LineInput& lines) const = 0;

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) final;

    raster::LinePass line_pass_;
};

}  // namespace ink::buffers
