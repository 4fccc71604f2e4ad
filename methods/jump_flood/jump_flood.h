#pragma once

#include "buffers/id_pass.h"
#include "edge/jump_flood.h"

namespace ink::methods {

/// Lines of any width: borders of ids and of depth as seeds, spread by jump flooding.
class JumpFlood : public method::Method {
  public:
    struct Params : buffers::IdParams {
        double width_px = 2;
        double depth_step = 0.02;
        int threshold = 128;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit JumpFlood(const Params& params);

    void prepare(const scene::Scene& scene) override { ids_.prepare(scene); }
    [[nodiscard]] bool prepare_like(const method::Method& other,
                                    const scene::Scene& scene) override {
        const auto* same = dynamic_cast<const JumpFlood*>(&other);
        return same != nullptr && ids_.prepare_like(same->ids_, scene);
    }
    void pose(const scene::Scene& scene) override { ids_.pose(scene); }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    /// `ids`, see IdPass.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return {ids_.layer(frame)};
    }
    [[nodiscard]] int bytes_per_px() const override;
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  private:
    /// How far from a seed a pixel may be in the line.
    [[nodiscard]] int reach_px() const;

    Params params_;
    buffers::IdPass ids_;
    core::Image<edge::NearestSeed> seeds_;
    core::Image<edge::NearestSeed> scratch_;
    raster::SkipCounts skip_counts_{};
};

[[nodiscard]] method::MethodInfo jump_flood();

}  // namespace ink::methods
