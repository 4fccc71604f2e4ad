#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <memory>

#include "buffers/sample_grid.h"
#include "core/param.h"
#include "method/depth_code.h"
#include "method/method.h"
#include "raster/mesh/mesh_pass.h"
#include "raster/pass/bin.h"
#include "scene/surface.h"

namespace ink::buffers {

/// Which end of the depth range has the larger code.
enum class DepthSign { near_high, far_high };

/// The parameters of whatever reads depth and normals (section 3 of the design, "Method inputs").
struct InputParams {
    raster::DepthEncoding depth_encoding = raster::DepthEncoding::inverse;
    method::RangeSource depth_range = method::RangeSource::fit;
    DepthSign depth_sign = DepthSign::near_high;
    scene::NormalSource normals = scene::NormalSource::patch;
    double crease_deg = 40;
    raster::Interpolation interpolation = raster::Interpolation::affine;
    bool renormalise = false;
    raster::DepthFormat depth_format = raster::DepthFormat::q32;
    Samples samples = Samples::centre;  ///< a row of its own, see add_samples_param
};

/// Appends the row `crease_deg`.
template <class P>
core::ParamTable<P>& add_crease_param(
    core::ParamTable<P>& table,
    const char* doc = "Least dihedral deviation of an edge between two smooth patches.") {
    return table.number(&P::crease_deg, "crease_deg", {0, 180}, "deg", doc);
}

/// Appends the rows that say what a smooth patch is: `crease_deg`, and `weld_epsilon` "for" what.
template <class P>
core::ParamTable<P>& add_patch_params(core::ParamTable<P>& table, const std::string& purpose) {
    return add_crease_param(table).number(&P::weld_epsilon,
                                          "weld_epsilon",
                                          {0, 0.01},
                                          "",
                                          "Vertices of an object this near are welded for its " +
                                              purpose + ", as a share of its diagonal.");
}

/// Appends the row `depth_format`.
template <class P>
core::ParamTable<P>& add_depth_format_param(core::ParamTable<P>& table,
                                            const char* doc = "Format of the depth test.") {
    return table.choice(&P::depth_format, "depth_format", {"q32", "z24", "z16"}, doc);
}

/// Appends the row `depth_range`.
template <class P>
core::ParamTable<P>& add_depth_range_param(core::ParamTable<P>& table) {
    return table.choice(
        &P::depth_range,
        "depth_range",
        {"fit", "camera"},
        "What depth 0..1 spans: the scene's bounding sphere, or the camera's near and far.");
}

/// Appends the row `interpolation`.
template <class P>
core::ParamTable<P>& add_interpolation_param(core::ParamTable<P>& table) {
    return table.choice(&P::interpolation,
                        "interpolation",
                        {"affine", "perspective"},
                        "Linear on the screen, as 1998's hardware did, or on the surface.");
}

/// Appends the rows of InputParams that say what the surface gives, whatever depth is made of.
template <class P>
core::ParamTable<P>& add_surface_params(core::ParamTable<P>& table) {
    table.choice(&P::normals,
                 "normals",
                 {"file", "patch", "facet"},
                 "The file's normals, per corner over its smooth patch, or one per triangle.");
    add_interpolation_param(add_crease_param(table))
        .flag(&P::renormalise,
              "renormalise",
              "Scale interpolated normals to length 1 at every pixel.");
    return add_depth_format_param(table);
}

/// Appends the rows of InputParams to a table whose struct derives from it.
template <class P>
core::ParamTable<P>& add_input_params(core::ParamTable<P>& table) {
    table.choice(&P::depth_encoding,
                 "depth_encoding",
                 {"inverse", "linear", "log", "zbuffer24", "zbuffer16", "reversed_float"},
                 "How distance becomes a number; only 1/w is flat on a plane.");
    add_depth_range_param(table).choice(
        &P::depth_sign, "depth_sign", {"near_high", "far_high"}, "Which end of the range is 1.");
    return add_surface_params(table);
}

/// Depth and the view-space normal's components as linear values: what a linear code adds up.
struct LinearChannels {
    raster::LinearValue depth;  ///< encoded as `inverse`: 1 at the range's near end, 0 at its far
    raster::LinearValue normal[3];
};

/// Whether a surface is laid out with normals, by which corners part, or by positions alone.
enum class Reads { normals, positions };

/// What pose() found.
enum class Posed {
    still,  ///< nothing moved
    moved,  ///< the same triangles elsewhere
    anew,   ///< triangles that join other corners: all was laid out again
};

/// A scene laid out for the rasterizer's lanes, what of it moved, and the image that is kept for
/// tiles that nothing moved in.
///
/// A method calls see(), draws with mesh_input(), and finish() last.
class SurfaceInputs {
  public:
    explicit SurfaceInputs(const InputParams& params, Reads reads = Reads::normals)
        : params_(params), reads_(reads) {}

    /// Once per topology: normals, shared corners, clusters.
    void prepare(const scene::PreparedScene& scene);
    /// World positions, and normals again, if anything moved since.
    Posed pose(const scene::PreparedScene& scene);
    /// The view, its depth range, and whether the last frame had the same.
    void see(const method::Frame& frame);

    /// What there is to draw, as it is posed.
    [[nodiscard]] const scene::Surface& surface() const { return *surface_; }
    /// The same laid out for lanes.
    [[nodiscard]] const raster::LaneMesh& mesh() const { return mesh_; }
    /// Whether there is nothing to draw.
    [[nodiscard]] bool is_empty() const { return !surface_ || surface_->triangles.empty(); }
    [[nodiscard]] const raster::DepthRange& range() const { return range_; }
    /// What the pass of the frame that was seen draws: its view, or that of its pixel corners.
    [[nodiscard]] const scene::View& view() const { return view_; }
    [[nodiscard]] glm::mat3 view_from_world() const;
    [[nodiscard]] LinearChannels linear_channels() const;
    /// A pass over this surface as it was seen, that still lacks values and sky.
    [[nodiscard]] raster::MeshInput mesh_input(const method::Frame& frame) const;
    /// Instead of finish(), for who drew something else than the method's image: the next frame
    /// keeps no tile of the last.
    void forget_image() { last_.is_kept = false; }
    /// Copies what was not drawn because nothing moved there, and keeps the image for the next
    /// frame once the scene has begun to move. `out` is what a pass over mesh_input() drew, of the
    /// frame's own size wherever its samples lie.
    void finish(const raster::MeshResult& result, edge::EdgeImage& out);

  private:
    /// Surface and clusters of the scene as it stands, from nothing: no image is kept.
    void lay_out(const scene::PreparedScene& scene);
    [[nodiscard]] std::shared_ptr<const scene::Surface> flattened(
        const scene::PreparedScene& scene) const;

    struct Kept {
        edge::EdgeImage image;
        bool is_kept = false;
    };

    InputParams params_;
    Reads reads_;
    std::shared_ptr<const scene::Surface> surface_;  ///< the mesh borrows it
    raster::LaneMesh mesh_;
    scene::Sphere bounds_;
    scene::Sphere seen_bounds_;  ///< of the last frame
    std::uint64_t posed_hash_ = 0;
    std::uint64_t moved_objects_ = 0;  ///< since the last draw, modulo 64
    bool has_moved_ = false;           ///< ever, since prepare
    bool keeps_still_ = false;
    bool is_still_ = false;  ///< this frame's camera, size and range are the last one's
    Kept last_;
    scene::View view_;  ///< of the samples
    raster::DepthRange range_;
};

}  // namespace ink::buffers
