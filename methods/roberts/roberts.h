#pragma once

#include "buffers/full_buffers.h"

namespace ink::methods {

/// Roberts' cross on depth and normals with a guard against grazing angles, as engines run it.
class Roberts : public method::Method {
  public:
    /// How the threshold on depth grows where a surface is seen at a grazing angle.
    enum class Guard {
        none,
        ramp,    ///< from guard_start on, up to 1 + guard_scale times
        cosine,  ///< by 1 / |n . v|, in step with a plane's own slope, which is taken off
    };
    struct Params : buffers::InputParams {
        Guard guard = Guard::cosine;
        double guard_start = 0.5;
        double guard_scale = 7;
        // found: ODS over the training scenes at 1280x720, `inkbench compare`; see the page
        double depth_step = 0.0025;
        double normal_step = 0.2;
        int threshold = 74;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Roberts(const Params& params);

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

[[nodiscard]] method::MethodInfo roberts();

}  // namespace ink::methods
