#pragma once

#include <vector>

#include "buffers/full_buffer_method.h"
#include "edge/decaudin_filter.h"

namespace ink::methods {

/// Decaudin's outlines from full depth and normal buffers: the reference of the seeds' line.
class Decaudin : public buffers::FullBufferMethod {
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
        // found: experiments/thresholds.py, over the training scenes at 1280x720
        int threshold = 146;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Decaudin(const Params& params);

  private:
    void filter(const buffers::FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override;
    [[nodiscard]] method::PixelWork filter_work() const override;

    Params params_;
};

[[nodiscard]] method::MethodInfo decaudin();

}  // namespace ink::methods
