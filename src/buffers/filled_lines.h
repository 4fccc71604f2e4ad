#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "buffers/depth_fill.h"
#include "buffers/surface_method.h"
#include "raster/lines/line_pass.h"

namespace ink::buffers {

/// Which edges of triangles a wireframe has.
enum class WireEdges {
    all,       ///< of every triangle
    polygons,  ///< without those that only cut a flat polygon in triangles
};

/// A scene as wireframe methods draw it: triangles to fill, and their edges as lines.
///
/// OpenGL's glPolygonMode draws an edge with each of its triangles, once in either direction; here
/// it is one line there and back. A polygon's inner edges are those between two triangles of one
/// object and material that bend by less than scene::kFlat_rad as the scene is posed. Triangles
/// that are degenerate when it is prepared have no edges.
class TriangleEdges : public DepthFill {
  public:
    explicit TriangleEdges(WireEdges edges,
                           raster::DepthFormat depth_format = raster::DepthFormat::q32)
        : DepthFill({.depth_format = depth_format}), edges_(edges) {}

    /// Once per topology.
    void prepare(const scene::PreparedScene& scene);
    /// World positions again, if anything moved since; with WireEdges::polygons also the edges, by
    /// a new weld, for what was flat may have bent.
    void pose(const scene::PreparedScene& scene);

    /// The corners that lines join.
    [[nodiscard]] const scene::Surface& surface() const { return inputs().surface(); }
    /// All of them; they join corners of surface().
    [[nodiscard]] std::span<const raster::Line> lines() const { return lines_->lines; }
    /// Those of at least one triangle that the eye sees from its back (`side` < 0) or from its
    /// front or its rim (`side` >= 0). Valid until the next call.
    [[nodiscard]] std::span<const raster::Line> lines_of_side(int side, const method::Frame& frame);

  private:
    /// The triangles of a line: the first runs along it, the second against it. The second is the
    /// first again where there is only one; an edge of more than two is several lines.
    struct Faces {
        std::uint32_t first = 0;
        std::uint32_t second = 0;
    };

    struct Lines {
        std::vector<raster::Line> lines;
        std::vector<Faces> faces;  ///< one per line
    };
    [[nodiscard]] Lines lines_of(const scene::PreparedScene& scene) const;
    void find_lines(const scene::PreparedScene& scene);
    void find_sides(const method::Frame& frame);

    WireEdges edges_;
    std::shared_ptr<const Lines> lines_ = std::make_shared<const Lines>();
    std::vector<std::int8_t> sides_;  ///< one per triangle, of the last frame
    std::vector<raster::Line> shown_;
};

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
