#pragma once

#include "buffers/full_buffer_method.h"

namespace ink::methods {

/// Dark where a surface turns away from the eye: a contour without any edge.
class Facing : public FullBufferMethod {
  public:
    struct Params : InputParams {
        double limit = 0.3;
        int threshold = 128;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Facing(const Params& params) : FullBufferMethod(params, 0), params_(params) {}

  private:
    void filter(const FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override;
    [[nodiscard]] PixelWork filter_work() const override { return {3 * sizeof(float), 1, 16}; }

    Params params_;
};

[[nodiscard]] MethodInfo facing();

}  // namespace ink::methods
