#pragma once

#include <cstdint>
#include <vector>

#include "buffers/depth_fill.h"
#include "buffers/surface_method.h"
#include "raster/lines/line_pass.h"

namespace ink::buffers {

/// What an edge of a mesh is in one view.
enum class EdgeKind : std::uint8_t {
    none,      ///< between faces that run on into each other
    contour,   ///< what is on one side of it faces away, or is not there
    crease,    ///< between two faces that bend
    boundary,  ///< of one face
};

/// An edge that is a line from where the camera stands, hidden or not.
struct KnownEdge {
    glm::dvec3 a_world{0};
    glm::dvec3 b_world{0};
    EdgeKind kind = EdgeKind::none;
};

/// As what an edge of one face is drawn.
enum class BoundaryEdges { contour, crease, none };

/// The parameters of whatever draws known edges and hides them by the depth buffer.
struct HiddenLineParams {
    double width_contour_px = 2;
    double width_crease_px = 1;
    double crease_deg = 40;
    // found: F of edge_hash over the training scenes at 1280x720, all views: 0 .975, 0.25 .981,
    // 0.5 .983, 0.75 .982, 1 .981, 2 .981, 3 .980; units of 0 to 64 change nothing there
    double offset_factor = 0.5;
    double offset_units = 1;
    raster::DepthFormat depth_format = raster::DepthFormat::z24;
    BoundaryEdges boundary_edges = BoundaryEdges::contour;
    int threshold = 128;  ///< 0 and 255 alone are drawn
};

/// Appends the rows of HiddenLineParams but `boundary_edges` to a table whose struct derives from
/// it.
template <class P>
core::ParamTable<P>& add_hidden_line_params(core::ParamTable<P>& table) {
    table
        .number(&P::width_contour_px,
                "width_contour_px",
                {1, 16},
                "px",
                "Width of contours, to the nearest whole pixel.")
        .number(&P::width_crease_px,
                "width_crease_px",
                {1, 16},
                "px",
                "Width of creases, to the nearest whole pixel.");
    add_crease_param(table,
                     "Least dihedral deviation of an edge between two seen faces that is a line.")
        .number(&P::offset_factor,
                "offset_factor",
                {-16, 16},
                "",
                "Polygon offset of the fills, times their slope; positive pushes them away.")
        .number(&P::offset_units,
                "offset_units",
                {-65536, 65536},
                "",
                "Polygon offset of the fills, in steps of the depth format.");
    return method::add_threshold(
        add_depth_format_param(table, "Format of the depth buffer that hides lines."));
}

/// How wide each kind of edge is drawn, px; 0 leaves it out.
struct KindWidths {
    double contour_px = 0;
    double crease_px = 0;
    double boundary_px = 0;

    [[nodiscard]] double of(EdgeKind kind) const;
};

/// A surface that hides lines: filled into a depth buffer, then lines drawn over it where they are
/// not behind it.
class HiddenLines : public DepthFill {
  public:
    explicit HiddenLines(const HiddenLineParams& params);

    /// Depth of the frame, its surface moved by the polygon offset. Returns what was skipped.
    raster::SkipCounts fill(const method::Frame& frame);
    /// Sets to 255 what is seen of the edges, each as wide as its kind; the rest of `out` stays.
    /// After fill() of the same frame.
    void draw(const method::Frame& frame,
              const std::vector<KnownEdge>& edges,
              const KindWidths& widths,
              edge::EdgeImage& out);

  private:
    HiddenLineParams params_;
    raster::LinePass line_pass_;
    std::vector<glm::dvec3> p_world_;  ///< of the lines of one width
    std::vector<raster::Line> lines_;
};

/// A method that draws edges where no surface hides them: all but which.
class HiddenLinesMethod : public SurfaceMethod<HiddenLines> {
  protected:
    explicit HiddenLinesMethod(const HiddenLineParams& params);

    /// The edges of a frame, hidden or not.
    virtual std::vector<KnownEdge> lines(const method::Frame& frame) = 0;

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) final;

    KindWidths widths_;
};

}  // namespace ink::buffers
