#pragma once

#include "buffers/full_buffers.h"

namespace ink::methods {

/// Roberts' cross on the distance of each pixel's plane from the eye, n . p, and on the normal:
/// nothing changes within a face, however it is seen.
class PlaneDistance : public method::Method {
  public:
    struct Params : buffers::InputParams {
        // found: ODS over the training scenes at 1280x720, `inkbench compare`; see the page
        double plane_step = 0.16;
        double normal_step = 0.2;
        int threshold = 82;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit PlaneDistance(const Params& params);

    void prepare(const scene::Scene& scene) override { buffers_.prepare(scene); }
    void pose(const scene::Scene& scene) override { buffers_.pose(scene); }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    /// `depth` and `normal`, see FullBuffers.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return buffers_.layers(frame);
    }
    [[nodiscard]] int bytes_per_px() const override { return buffers_.format().bytes_per_px(); }
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  private:
    Params params_;
    buffers::FullBuffers buffers_;
    raster::SkipCounts skip_counts_{};
};

[[nodiscard]] method::MethodInfo plane_distance();

}  // namespace ink::methods
