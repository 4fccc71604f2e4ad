#pragma once

#include "edge/jump_flood.h"
#include "methods/id_pass.h"

namespace ink::methods {

/// Lines of any width: borders of ids and of depth as seeds, spread by jump flooding.
class JumpFlood : public Method {
  public:
    struct Params : IdParams {
        double width_px = 2;
        double depth_step = 0.02;
        int threshold = 128;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit JumpFlood(const Params& params);

    void prepare(const scene::Scene& scene) override { ids_.prepare(scene); }
    void pose(const scene::Scene& scene) override { ids_.pose(scene); }
    void draw(const Frame& frame, edge::EdgeImage& out) override;
    /// `ids`, see IdPass.
    [[nodiscard]] std::vector<Layer> layers(const Frame& frame) override {
        return {ids_.layer(frame)};
    }
    [[nodiscard]] int bytes_per_px() const override;
    [[nodiscard]] Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  private:
    /// How far from a seed a pixel may be in the line.
    [[nodiscard]] int reach_px() const;

    Params params_;
    IdPass ids_;
    core::Image<edge::NearestSeed> seeds_;
    core::Image<edge::NearestSeed> scratch_;
    raster::SkipCounts skip_counts_{};
};

[[nodiscard]] MethodInfo jump_flood();

}  // namespace ink::methods
