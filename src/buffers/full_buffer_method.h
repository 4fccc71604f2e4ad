#pragma once

#include "buffers/full_buffers.h"
#include "buffers/surface_cross.h"
#include "buffers/surface_method.h"

namespace ink::buffers {

/// What a filter over full buffers is told of its frame.
struct FullBufferFrame {
    method::DepthCarrier carrier;
    raster::DepthRange range;  ///< the distances that depth 1 and 0 stand for
    PixelRays rays;
};

/// Appends the row `sky`.
template <class P>
core::ParamTable<P>& add_sky_depth_param(core::ParamTable<P>& table) {
    return table.number(&P::sky,
                        "sky",
                        {-1, 1},
                        "depth",
                        "Depth of empty pixels; -1 stands for infinity, a whole range beyond far.");
}

/// Appends the row `normal_step`, of write_cross.
template <class P>
core::ParamTable<P>& add_normal_step_param(core::ParamTable<P>& table) {
    return table.number(
        &P::normal_step,
        "normal_step",
        {1e-3, 2},
        "",
        "Least change of the normal that is a line: 2 sin(a/2) for a crease of angle a.");
}

/// A method that filters depth and view-space normals as floats: all but the filter itself.
class FullBufferMethod : public SurfaceMethod<FullBuffers> {
  public:
    /// `depth` and `normal`, see FullBuffers.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return pass().layers(frame);
    }

  protected:
    /// The filter sees `halo_px` pixels beyond its tile, and depth `sky` where nothing is; with
    /// kNothingDrawn it sees depth as it was carried and encodes it itself.
    FullBufferMethod(const InputParams& params, int halo_px, float sky = method::kNothingDrawn)
        : SurfaceMethod(params, halo_px), sky_(sky) {}

    /// Writes the edge responses of a tile that something was drawn to. Called by several threads,
    /// for a tile each.
    virtual void filter(const FullBufferFrame& frame,
                        const raster::Tile& tile,
                        edge::EdgeImage& out) const = 0;

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) final;

    float sky_;
};

/// What encoded_depth() moves at a pixel.
[[nodiscard]] method::PixelBytes encoded_depth_bytes(const InputParams& params);

/// What view_normals() moves at a pixel.
[[nodiscard]] method::PixelBytes view_normals_bytes(bool renormalise);

}  // namespace ink::buffers
