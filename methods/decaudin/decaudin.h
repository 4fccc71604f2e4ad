#pragma once

#include <vector>

#include "buffers/full_buffers.h"
#include "edge/decaudin_filter.h"
#include "method/method.h"

namespace ink::methods {

/// Decaudin's outlines from full depth and normal buffers: the reference of the seeds' line.
class Decaudin : public method::Method {
  public:
    enum class Join {
        max,     ///< the largest p
        either,  ///< 1 - prod(1 - p): the soft "or"
        length,  ///< the length of the vector of p, at most 1
    };
    struct Params : buffers::InputParams {
        double k_depth = 0.02;
        double k_normal = 0.25;
        edge::KPlace k_place = edge::KPlace::inside;
        Join join = Join::max;
        double sky = -1;
        // found: ODS over the training scenes at 1280x720, `inkbench compare`, default settings
        int threshold = 146;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Decaudin(const Params& params);

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

[[nodiscard]] method::MethodInfo decaudin();

}  // namespace ink::methods
