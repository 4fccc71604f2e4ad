#pragma once

#include "buffers/constant_pass.h"
#include "buffers/surface_method.h"
#include "methods/id_lookup/lookup_mesh.h"
#include "methods/id_lookup/screen_mesh.h"

namespace ink::methods {

struct IdLookupParams {
    double crease_deg = 40;
    double weld_epsilon = 1e-4;  // that of ids
    int steps = 64;
    buffers::Samples samples = buffers::Samples::corner;
    raster::DepthFormat depth_format = raster::DepthFormat::q32;
    int threshold = 128;  ///< it draws 0 and 255 alone
};

/// A scene drawn as faces of the mesh in which lines are looked up, kNoNeighbour where nothing is.
class FacePass : public buffers::ConstantPass {
  public:
    explicit FacePass(const IdLookupParams& params);

    /// What draws: the mesh, as the frame that was seen last sees it.
    [[nodiscard]] const ScreenMesh& screen() const { return screen_; }

  protected:
    [[nodiscard]] std::vector<std::uint32_t> constants_of(
        const scene::PreparedScene& scene) override;
    /// What meets, and which edges crease, may change with the pose.
    [[nodiscard]] bool follows(const scene::Scene& /*scene*/) const override { return true; }
    void follow_view(const method::Frame& frame) override;

  private:
    IdLookupParams params_;
    LookupMesh mesh_;
    ScreenMesh screen_;
};

/// Triangle ids; where neighbouring samples differ, the mesh says whether a line lies between them
/// and of which class it is.
class IdLookup : public buffers::SurfaceMethod<FacePass> {
  public:
    using Params = IdLookupParams;
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit IdLookup(const Params& params) : SurfaceMethod(params), params_(params) {}

    /// `classes`: a colour for the class of each line, white where there is none.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override;
    /// The class of the line at each pixel, LineKind; drawn anew.
    [[nodiscard]] core::Image<LineKind> classes(const method::Frame& frame);

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override;
    /// Walks are few, and depend on the scene.
    [[nodiscard]] method::PixelBytes filter_bytes() const override { return {4, 1}; }

    Params params_;
};

}  // namespace ink::methods
