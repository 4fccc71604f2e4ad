#pragma once

#include "buffers/full_buffer_method.h"

namespace ink::methods {

/// Dark where a surface turns away from the eye: one sample a pixel, no neighbour is looked at.
class Rim : public buffers::FullBufferMethod {
  public:
    struct Params : buffers::InputParams {
        double limit = 0.2;  // found: see the page
        int threshold = 1;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Rim(const Params& params) : buffers::FullBufferMethod(params, 0), params_(params) {}

  private:
    void filter(const buffers::FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override;
    [[nodiscard]] method::PixelWork filter_work() const override;

    Params params_;
};

[[nodiscard]] method::MethodInfo rim();

}  // namespace ink::methods
