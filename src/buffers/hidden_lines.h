#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "buffers/known_edge.h"
#include "core/param.h"
#include "method/method.h"
#include "raster/depth/depth_image.h"
#include "raster/lines/line_pass.h"
#include "raster/mesh/mesh_pass.h"
#include "scene/surface.h"

namespace ink::buffers {

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
};

/// Appends the rows of HiddenLineParams to a table whose struct derives from it.
template <class P>
core::ParamTable<P>& add_hidden_line_params(core::ParamTable<P>& table) {
    return table
        .number(&P::width_contour_px,
                "width_contour_px",
                {1, 16},
                "px",
                "Width of contours, to the nearest whole pixel.")
        .number(&P::width_crease_px,
                "width_crease_px",
                {1, 16},
                "px",
                "Width of creases, to the nearest whole pixel.")
        .number(&P::crease_deg,
                "crease_deg",
                {0, 180},
                "deg",
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
                "Polygon offset of the fills, in steps of the depth format.")
        .choice(&P::depth_format,
                "depth_format",
                {"q32", "z24", "z16"},
                "Format of the depth buffer that hides lines.");
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
class HiddenLines {
  public:
    explicit HiddenLines(const HiddenLineParams& params);

    /// Once per topology: clusters for the rasterizer.
    void prepare(const scene::Scene& scene);
    /// World positions, if anything moved since.
    void pose(const scene::Scene& scene);

    /// Whether there is nothing to draw.
    [[nodiscard]] bool is_empty() const { return !surface_ || surface_->triangles.empty(); }
    /// Depth of the frame, its surface moved by the polygon offset.
    void fill(const method::Frame& frame);
    /// Sets to 255 what is seen of the edges, each as wide as its kind; the rest of `out` stays.
    /// After fill() of the same frame.
    void draw(const method::Frame& frame,
              const std::vector<KnownEdge>& edges,
              const KindWidths& widths,
              edge::EdgeImage& out);

    /// What fill() made.
    [[nodiscard]] const raster::DepthImage& depth() const { return depth_; }
    [[nodiscard]] const raster::SkipCounts& skip_counts() const { return skip_counts_; }
    [[nodiscard]] int bytes_per_px() const { return format_.bytes_per_px(); }
    [[nodiscard]] method::Cost cost() const;

  private:
    HiddenLineParams params_;
    raster::PassFormat format_;
    std::unique_ptr<scene::Surface> surface_;  ///< the mesh borrows it
    raster::LaneMesh mesh_;
    scene::Sphere bounds_;
    std::uint64_t posed_hash_ = 0;
    raster::MeshPass mesh_pass_;
    raster::LinePass line_pass_;
    raster::DepthImage depth_;
    raster::SkipCounts skip_counts_{};
    std::vector<glm::dvec3> p_world_;  ///< of the lines of one width
    std::vector<raster::Line> lines_;
};

}  // namespace ink::buffers
