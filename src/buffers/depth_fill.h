#pragma once

#include "buffers/surface_pass.h"
#include "raster/depth/depth_image.h"

namespace ink::buffers {

/// A scene filled into a frame's depth, against which lines or another surface are tested.
class DepthFill : public SurfacePass {
  public:
    /// Corners are shared by position alone, unless normals are read.
    explicit DepthFill(const InputParams& params, Reads reads = Reads::positions);

    /// A pass over the scene that still lacks culling and offset.
    [[nodiscard]] raster::MeshInput see(const method::Frame& frame);
    /// Fills the frame's depth. Returns what was skipped.
    raster::SkipCounts fill(const raster::MeshInput& input);
    /// What fill() made.
    [[nodiscard]] raster::DepthImage& depth() { return depth_; }

    /// Depth goes from its tile to the frame, and the image is cleared. Lines are not in it: they
    /// cost by their length on the screen, which depends on scene and view, and no Cost knows them.
    [[nodiscard]] method::Cost cost() const;

  private:
    raster::DepthImage depth_;
};

}  // namespace ink::buffers
