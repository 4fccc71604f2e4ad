#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/param.h"
#include "methods/depth_code.h"
#include "methods/method.h"
#include "methods/vertex_cut.h"
#include "raster/pass.h"
#include "scene/surface.h"

namespace ink::methods {

/// Which end of the depth range has the larger code.
enum class DepthSign { near_high, far_high };

/// The knobs of whatever reads depth and normals (section 3 of the design, "Method inputs").
struct InputParams {
    raster::DepthEncoding depth_encoding = raster::DepthEncoding::inverse;
    RangeSource depth_range = RangeSource::fit;
    DepthSign depth_sign = DepthSign::near_high;
    scene::NormalSource normals = scene::NormalSource::patch;
    double crease_deg = 40;
    raster::Interpolation interpolation = raster::Interpolation::affine;
    bool renormalise = false;
    raster::DepthFormat depth_format = raster::DepthFormat::q32;
};

/// Appends the rows of InputParams to a table whose struct derives from it.
template <class P>
core::ParamTable<P>& add_input_params(core::ParamTable<P>& table) {
    return table
        .choice(&P::depth_encoding,
                "depth_encoding",
                {"inverse", "linear", "log", "zbuffer24", "zbuffer16", "reversed_float"},
                "How distance becomes a number; only 1/w is flat on a plane.")
        .choice(&P::depth_range,
                "depth_range",
                {"fit", "camera"},
                "What depth 0..1 spans: the scene's bounding sphere, or the camera's near and far.")
        .choice(
            &P::depth_sign, "depth_sign", {"near_high", "far_high"}, "Which end of the range is 1.")
        .choice(&P::normals,
                "normals",
                {"file", "patch", "facet"},
                "The file's normals, per corner over its smooth patch, or one per triangle.")
        .number(&P::crease_deg,
                "crease_deg",
                {0, 180},
                "deg",
                "Bend from which on an edge parts two smooth patches.")
        .choice(&P::interpolation,
                "interpolation",
                {"affine", "perspective"},
                "Linear on the screen, as 1998's hardware did, or on the surface.")
        .flag(&P::renormalise,
              "renormalise",
              "Scale interpolated normals to length 1 at every pixel.")
        .choice(
            &P::depth_format, "depth_format", {"q32", "z24", "z16"}, "Format of the depth test.");
}

/// A scene's depth and normals as a pass takes them, kept between frames so that none allocates
/// twice.
///
/// Every corner that a triangle uses lies at or beyond the near plane: triangles that cross it are
/// cut before anything is computed at vertices, as a 1998 engine did (methods/vertex_cut.h).
class SurfaceInputs {
  public:
    explicit SurfaceInputs(const InputParams& params);

    /// Once per topology: normals, shared corners.
    void prepare(const scene::Scene& scene);
    /// World positions, and normals again, if anything moved since.
    void pose(const scene::Scene& scene);
    /// All that depends on the camera: view space, facing, near cut, depth range.
    void see(const Frame& frame);

    /// Whether there is nothing to draw.
    [[nodiscard]] bool is_empty() const { return surface_.triangles.empty(); }
    /// Corners that see() left, those at cuts included.
    [[nodiscard]] std::size_t corner_count() const { return vertices_.p_clip.size(); }
    /// Their normals in view space, unit but at cuts; of a triangle's front side.
    [[nodiscard]] std::span<const glm::vec3> n_view() const { return vertices_.n_view; }
    [[nodiscard]] const raster::DepthRange& range() const { return range_; }
    /// Depth as `carrier` carries it and the view-space normal, four floats per corner: `front`,
    /// and `back` with the normal negated.
    void gather_channels(const DepthCarrier& carrier,
                         int threads,
                         std::vector<float>& front,
                         std::vector<float>& back) const;
    /// Distance of corner i along the gaze; what a cut left unused counts as lying at the near
    /// plane.
    [[nodiscard]] double w(std::size_t i) const {
        return std::max(vertices_.p_clip[i].z, camera_.near);
    }
    /// A pass over this surface that still lacks values and sky.
    [[nodiscard]] raster::PassInput pass_input() const;

  private:
    void transform(const Frame& frame);

    InputParams params_;
    scene::Surface surface_;
    scene::Sphere bounds_;
    std::uint64_t posed_hash_ = 0;

    CutVertices vertices_;
    std::vector<std::int8_t> facing_;
    CutTriangles cut_;
    bool is_cut_ = false;  ///< whether `cut_` is drawn in place of the surface's own triangles
    scene::Camera camera_;
    raster::DepthRange range_;
};

/// Calls body(first, last) over [0, count) in runs that do not depend on the number of threads.
void for_runs(std::size_t count,
              int threads,
              const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace ink::methods
