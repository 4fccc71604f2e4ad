#pragma once

#include "buffers/full_buffer_method.h"

namespace ink::methods {

/// Roberts' cross on depth and normals with a guard against grazing angles, as engines run it.
class Roberts : public buffers::FullBufferMethod {
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
        // found: experiments/thresholds.py, over the training scenes at 1280x720; see the page
        double depth_step = 0.0025;
        double normal_step = 0.2;
        int threshold = 74;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Roberts(const Params& params);

  private:
    void filter(const buffers::FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override;
    [[nodiscard]] method::PixelWork filter_work() const override;
    [[nodiscard]] float guarded(float step, float facing, float per_px) const;

    Params params_;
};

[[nodiscard]] method::MethodInfo roberts();

}  // namespace ink::methods
