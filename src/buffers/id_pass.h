#pragma once

#include "buffers/constant_pass.h"
#include "buffers/surface_method.h"
#include "scene/prepared_scene.h"

namespace ink::buffers {

/// What an id tells apart.
enum class IdSource {
    object,  ///< the instance
    patch,   ///< faces joined over edges that bend by less than a crease, over objects too
    object_and_patch,  ///< the same within one object
    triangle,          ///< every face: a wireframe
};

/// What an id image holds where nothing was drawn. No triangle has it.
inline constexpr std::uint32_t kNoId = 0xffffffffU;

/// What makes patches of faces.
struct PatchOptions {
    double crease_rad = 0;  ///< dihedral deviation from which on an edge parts two patches, 0..pi
    /// How near vertices of one object must lie to be one, as a share of its diagonal; 0: at the
    /// same place only. What that makes flat, or alike, has ids of its own.
    double weld_epsilon = 0;
};

/// One id per triangle of the scene, by global index; equal where `source` tells nothing apart.
///
/// Patches are numbered by their first triangles, so that a patch keeps its id while others change.
/// Only edges of two faces join, whichever way these are turned. A triangle that repeats another
/// has the id of that one; one without area has its own, and covers nothing. O(n log n); an empty
/// scene has no ids.
[[nodiscard]] std::vector<std::uint32_t> surface_ids(const scene::PreparedScene& scene,
                                                     IdSource source,
                                                     const PatchOptions& options);

/// The parameters of whatever draws ids; who offers no depth format has q32.
struct IdParams {
    IdSource of = IdSource::object_and_patch;
    double crease_deg = 40;
    double weld_epsilon = 1e-4;  // found: the least that closes cracks, see ids.md
    Samples samples = Samples::centre;
    raster::DepthFormat depth_format = raster::DepthFormat::q32;
};

/// Appends the rows of IdParams but depth_format to a table whose struct derives from it.
template <class P>
core::ParamTable<P>& add_id_params(core::ParamTable<P>& table) {
    table.choice(&P::of,
                 "of",
                 {"object", "patch", "object_and_patch", "triangle"},
                 "What has an id of its own: objects, smooth patches, both, or every triangle.");
    return add_samples_param(add_patch_params(table, "patches"));
}

/// Which pixels show a border between two ids.
enum class BorderSide {
    nearer,  ///< one pixel wide, on the surface that is in front
    both,    ///< two: each pixel that has another id beside it
};

/// Appends the row `side` to a table whose struct has such a member.
template <class P>
core::ParamTable<P>& add_side_param(core::ParamTable<P>& table) {
    return table.choice(
        &P::side,
        "side",
        {"nearer", "both"},
        "Where a border's line lies: one pixel on the nearer surface, or both sides of it. "
        "With corner samples it lies in the pixel between, and this has no meaning.");
}

/// A scene drawn as ids, u32 in plane 0, kNoId where nothing is.
class IdPass : public ConstantPass {
  public:
    IdPass(const IdParams& params, int halo_px);

    /// `ids`: a colour for every id, sky black.
    [[nodiscard]] method::Layer layer(const method::Frame& frame);

  protected:
    [[nodiscard]] std::vector<std::uint32_t> constants_of(
        const scene::PreparedScene& scene) override;
    /// Patches may part where a surface bends.
    [[nodiscard]] bool follows(const scene::Scene& scene) const override;

  private:
    IdParams params_;
};

/// A method that draws its lines from ids: all but what it makes of them.
class IdMethod : public SurfaceMethod<IdPass> {
  public:
    /// `ids`, see IdPass.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return {pass().layer(frame)};
    }

  protected:
    /// Tiles have `halo_px` pixels beyond their own.
    IdMethod(const IdParams& params, int halo_px) : SurfaceMethod(params, halo_px) {}
};

}  // namespace ink::buffers
