#pragma once

#include "buffers/surface_inputs.h"
#include "methods/id_lookup/lookup_mesh.h"
#include "methods/id_lookup/screen_mesh.h"

namespace ink::methods {

/// Triangle ids; where neighbouring samples differ, the mesh says whether a line lies between them
/// and of which class it is.
class IdLookup : public method::Method {
  public:
    struct Params {
        double crease_deg = 40;
        double weld_epsilon = 1e-4;  // that of ids
        int steps = 64;
        buffers::Samples samples = buffers::Samples::corner;
        raster::DepthFormat depth_format = raster::DepthFormat::q32;
        int threshold = 128;  ///< it draws 0 and 255 alone
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit IdLookup(const Params& params);

    void prepare(const scene::Scene& scene) override;
    void pose(const scene::Scene& scene) override;
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    /// `classes`: a colour for the class of each line, white where there is none.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override;
    /// The class of the line at each pixel, LineKind; drawn anew.
    [[nodiscard]] core::Image<LineKind> classes(const method::Frame& frame);
    [[nodiscard]] int bytes_per_px() const override { return format_.bytes_per_px(); }
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  private:
    void look_up(const scene::Scene& scene);
    /// Draws ids and hands each row of each tile to `write(tile, y, kinds)`; `kinds` is null where
    /// no pixel of it is a line.
    template <class Write>
    [[nodiscard]] raster::MeshResult draw_classes(const method::Frame& frame,
                                                  bool may_keep_still,
                                                  std::pair<int, int> size_px,
                                                  Write write);

    Params params_;
    raster::PassFormat format_;
    buffers::SurfaceInputs inputs_;
    raster::MeshPass pass_;
    LookupMesh mesh_;
    ScreenMesh screen_;
    std::uint64_t posed_hash_ = 0;
    bool have_ids_changed_ = false;  ///< since the last draw: then no tile is still
    raster::SkipCounts skip_counts_{};
};

[[nodiscard]] method::MethodInfo id_lookup();

}  // namespace ink::methods
