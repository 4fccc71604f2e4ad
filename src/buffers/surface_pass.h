#pragma once

#include "buffers/surface_inputs.h"

namespace ink::buffers {

/// A scene's surface and the pass that draws it: what every method that draws surfaces has.
///
/// prepare and pose as Method has them; then, for every frame, inputs().see() and draw().
class SurfacePass {
  public:
    SurfacePass(const InputParams& params,
                const raster::PassFormat& format,
                Reads reads = Reads::normals)
        : format_(format),
          shares_vertices_(params.normals != scene::NormalSource::facet),
          inputs_(params, reads) {}

    void prepare(const scene::PreparedScene& scene) { inputs_.prepare(scene); }
    void pose(const scene::PreparedScene& scene) { (void)inputs_.pose(scene); }
    [[nodiscard]] bool is_empty() const { return inputs_.is_empty(); }

    [[nodiscard]] const raster::PassFormat& format() const { return format_; }
    [[nodiscard]] SurfaceInputs& inputs() { return inputs_; }
    [[nodiscard]] const SurfaceInputs& inputs() const { return inputs_; }
    [[nodiscard]] raster::MeshResult draw(const raster::MeshInput& input, raster::TileSink& sink) {
        return mesh_pass_.draw(format_, input, sink);
    }

    /// Without a filter.
    [[nodiscard]] method::Cost cost() const {
        method::Cost cost = method::pass_cost(format_);
        cost.shares_vertices = shares_vertices_;
        return cost;
    }

  private:
    raster::PassFormat format_;
    bool shares_vertices_;
    SurfaceInputs inputs_;
    raster::MeshPass mesh_pass_;
};

}  // namespace ink::buffers
