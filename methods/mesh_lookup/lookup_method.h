#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "buffers/constant_pass.h"
#include "buffers/surface_method.h"
#include "methods/mesh_lookup/lookup_mesh.h"
#include "methods/mesh_lookup/screen_mesh.h"
#include "methods/mesh_lookup/side_lists.h"

namespace ink::methods {

struct LookupParams {
    double crease_deg = 40;
    double weld_epsilon = 1e-4;  // that of ids
    int steps = 64;
    buffers::Samples samples = buffers::Samples::corner;
    raster::DepthFormat depth_format = raster::DepthFormat::q32;
    int threshold = 128;  ///< it draws 0 and 255 alone
};

/// Appends the rows that say how lines are looked up.
template <class P>
core::ParamTable<P>& add_lookup_params(core::ParamTable<P>& table) {
    return buffers::add_crease_param(table, "Least dihedral deviation of an edge that is a crease.")
        .number(&P::weld_epsilon,
                "weld_epsilon",
                {0, 0.01},
                "",
                "Boundaries of an object this near meet, as a share of its diagonal.")
        .number(&P::steps,
                "steps",
                {1, 1000},
                "",
                "Most triangles crossed from one sample to the next before it gives up.");
}

/// Appends the row `jump_px`, of a method that looks depths up, too.
template <class P>
core::ParamTable<P>& add_jump_param(core::ParamTable<P>& table) {
    return table.number(&P::jump_px,
                        "jump_px",
                        {0, 1000},
                        "px",
                        "Least step of depth, beyond what the surface goes on by at either sample, "
                        "that is looked up; as long as so many pixels are there.");
}

/// The codes that lines are looked up with, of surface8, per triangle.
[[nodiscard]] std::vector<std::uint32_t> lookup_codes(const scene::PreparedScene& scene,
                                                      const LookupParams& params);

/// Which sides need no look-up: what codes of the surface tell, and depths.
struct CodedLookup {
    std::string_view method;  ///< who asks
    double jump_px = 0;
    int trust = 0;
};

/// A scene drawn as faces of the mesh in which lines are looked up, kNoNeighbour where nothing is;
/// with codes as words that hold them (LookupWord).
class LookupPass : public buffers::ConstantPass {
  public:
    LookupPass(const LookupParams& params, const std::optional<CodedLookup>& coded);
    void prepare(const scene::PreparedScene& scene);

    /// What draws: the mesh, as the frame that was seen last sees it.
    [[nodiscard]] const ScreenMesh& screen() const { return screen_; }
    /// What codes decide in that frame; null without codes.
    [[nodiscard]] const CodeRule* rule() const { return coded_ ? &rule_ : nullptr; }

  protected:
    [[nodiscard]] std::vector<std::uint32_t> constants_of(
        const scene::PreparedScene& scene) override;
    /// What meets, and which edges crease, may change with the pose.
    [[nodiscard]] bool follows(const scene::Scene& /*scene*/) const override { return true; }
    void follow_view(const method::Frame& frame) override;

  private:
    [[nodiscard]] std::vector<std::uint32_t> words_of(const scene::PreparedScene& scene);

    LookupParams params_;
    std::optional<CodedLookup> coded_;
    std::vector<std::uint32_t> codes_;  ///< per triangle; of the scene as it was prepared
    CodeRule rule_;
    LookupMesh mesh_;
    ScreenMesh screen_;
};

/// Faces of a mesh; where neighbouring samples differ, the mesh says whether a line lies between
/// them and of which class it is. What id_lookup and surface_lookup share.
class LookupMethod : public buffers::SurfaceMethod<LookupPass> {
  public:
    /// `classes`: a colour for the class of each line, white where there is none.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override;
    /// The class of the line at each pixel, LineKind; drawn anew. All sides are looked up.
    [[nodiscard]] core::Image<LineKind> classes(const method::Frame& frame);

  protected:
    explicit LookupMethod(const LookupParams& params, const std::optional<CodedLookup>& coded = {})
        : SurfaceMethod(params, coded), params_(params) {}

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override;
    /// Walks are few, and depend on the scene.
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        return {pass().rule() == nullptr ? 4.0 : 8.0, 1};
    }

    LookupParams params_;
};

}  // namespace ink::methods
