#pragma once

#include "buffers/full_buffer_method.h"

namespace ink::methods {

/// Roberts' cross on the distance of each pixel's plane from the eye, n . p, and on the normal:
/// nothing changes within a face, however it is seen.
class PlaneDistance : public buffers::FullBufferMethod {
  public:
    struct Params : buffers::InputParams {
        // found: experiments/thresholds.py, over the training scenes at 1280x720; see the page
        double plane_step = 0.16;
        double normal_step = 0.2;
        int threshold = 82;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit PlaneDistance(const Params& params);

  private:
    void filter(const buffers::FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override;
    [[nodiscard]] method::PixelWork filter_work() const override;

    Params params_;
};

[[nodiscard]] method::MethodInfo plane_distance();

}  // namespace ink::methods
