#pragma once

#include "buffers/full_buffers.h"
#include "buffers/surface_cross.h"

namespace ink::buffers {

/// What a filter over full buffers is told of its frame.
struct FullBufferFrame {
    method::DepthCarrier carrier;
    raster::DepthRange range;  ///< the distances that depth 1 and 0 stand for
    PixelRays rays;
};

/// A method that filters depth and view-space normals as floats: all but the filter itself.
///
/// The shell of decaudin, roberts, sobel and plane_distance.
class FullBufferMethod : public method::Method {
  public:
    void prepare(const scene::Scene& scene) override { buffers_.prepare(scene); }
    [[nodiscard]] bool prepare_like(const method::Method& other,
                                    const scene::Scene& /*scene*/) override {
        const auto* same = dynamic_cast<const FullBufferMethod*>(&other);
        return same != nullptr && buffers_.prepare_like(same->buffers_);
    }
    void pose(const scene::Scene& scene) override { buffers_.pose(scene); }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    /// `depth` and `normal`, see FullBuffers.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return buffers_.layers(frame);
    }
    [[nodiscard]] int bytes_per_px() const override { return buffers_.format().bytes_per_px(); }
    /// That of the pass and of filter_work().
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  protected:
    /// The filter sees `halo_px` pixels beyond its tile, and depth `sky` where nothing is; with
    /// kNothingDrawn it sees depth as it was carried and encodes it itself.
    FullBufferMethod(const InputParams& params, int halo_px, float sky = method::kNothingDrawn)
        : buffers_(params, halo_px), sky_(sky) {}

    /// Writes the edge responses of a tile that something was drawn to. Called by several threads,
    /// for a tile each.
    virtual void filter(const FullBufferFrame& frame,
                        const raster::Tile& tile,
                        edge::EdgeImage& out) const = 0;

    /// What filter() does at a pixel.
    [[nodiscard]] virtual method::PixelWork filter_work() const = 0;

  private:
    class Sink;

    FullBuffers buffers_;
    float sky_;
    raster::SkipCounts skip_counts_{};
};

/// What encoded_depth() does at a pixel.
[[nodiscard]] method::PixelWork encoded_depth_work(const InputParams& params);

/// What view_normals() does at a pixel.
[[nodiscard]] method::PixelWork view_normals_work(bool renormalise);

}  // namespace ink::buffers
