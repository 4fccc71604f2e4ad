#pragma once

#include "buffers/id_pass.h"
#include "buffers/surface_method.h"

namespace ink::buffers {

/// A method that draws its lines from ids: all but what it makes of them.
class IdMethod : public SurfaceMethod<IdPass> {
  public:
    /// `ids`, see IdPass.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return {pass().layer(frame)};
    }

  protected:
    /// Tiles have `halo_px` pixels beyond their own.
    IdMethod(const IdParams& params, int halo_px) : SurfaceMethod(params, halo_px) {}
};

}  // namespace ink::buffers
