#pragma once

#include "buffers/id_method.h"
#include "edge/jump_flood.h"

namespace ink::methods {

/// Lines of any width: borders of ids and of depth as seeds, spread by jump flooding.
class JumpFlood : public buffers::IdMethod {
  public:
    struct Params : buffers::IdParams {
        double width_px = 2;
        double depth_step = 0.02;
        int threshold = 128;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit JumpFlood(const Params& params);

    [[nodiscard]] int bytes_per_px() const override;
    [[nodiscard]] method::Cost cost() const override;

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override;
    /// How far from a seed a pixel may be in the line.
    [[nodiscard]] int reach_px() const;

    Params params_;
    core::Image<edge::NearestSeed> seeds_;
    core::Image<edge::NearestSeed> scratch_;
};

[[nodiscard]] method::MethodInfo jump_flood();

}  // namespace ink::methods
