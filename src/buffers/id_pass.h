#pragma once

#include "buffers/constant_pass.h"
#include "buffers/surface_ids.h"

namespace ink::buffers {

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

    /// See SurfaceInputs::prepare_like; ids are taken over, too, if they are of the same.
    [[nodiscard]] bool prepare_like(const IdPass& other, const scene::Scene& scene);
    /// `ids`: a colour for every id, sky black.
    [[nodiscard]] method::Layer layer(const method::Frame& frame);

  protected:
    [[nodiscard]] std::vector<std::uint32_t> constants_of(const scene::Scene& scene) override;
    /// Patches may part where a surface bends.
    [[nodiscard]] bool follows(const scene::Scene& scene) const override;

  private:
    IdParams params_;
};

}  // namespace ink::buffers
