#pragma once

#include "buffers/full_buffer_method.h"

namespace ink::methods {

/// Dark where a surface turns away from the eye: a contour without any edge.
class Facing : public buffers::FullBufferMethod {
  public:
    struct Params : buffers::InputParams {
        double limit = 0.3;
        int threshold = 128;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Facing(const Params& params) : buffers::FullBufferMethod(params, 0), params_(params) {}

  private:
    void filter(const buffers::FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override;
    [[nodiscard]] method::PixelWork filter_work() const override {
        return {3 * sizeof(float), 1, 16};
    }

    Params params_;
};

[[nodiscard]] method::MethodInfo facing();

}  // namespace ink::methods
