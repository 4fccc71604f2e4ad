#pragma once

#include "raster/depth/depth.h"
#include "raster/pass/setup.h"

namespace ink::raster {

/// What glPolygonOffset is given: negative numbers move it towards the eye.
struct PolygonOffset {
    double factor = 0;  ///< times the depth's slope, max(|dz/dx|, |dz/dy|) per px
    double units = 0;   ///< times the smallest resolvable step of the depth format

    [[nodiscard]] bool is_any() const { return factor != 0 || units != 0; }
};

/// Moves depths as OpenGL 1.1 does (specification, section 3.5.5): o = factor m + units r is added
/// to window depth, which grows away from the eye.
///
/// Here depth is q = 1/w, which is affine in window depth and grows towards the eye, so everything
/// is turned over: what is returned is added to q. r is one whole step of z24 or z16; for q32,
/// where depth itself is the float q, it is the step of floats at the nearest q of what is moved,
/// as OpenGL has it for floating-point depth. Nothing is limited here: depth formats do that.
class OffsetRule {
  public:
    /// `near` and `far` are not looked at for q32.
    OffsetRule(const PolygonOffset& offset, DepthFormat format, double near, double far);

    /// What is added to q where it changes by at most `slope` (>= 0) per px along x or y, and is
    /// nowhere more than `q_most`.
    [[nodiscard]] double depth_bias(double slope, double q_most) const;

    /// Moves a triangle that was set up: its plane and the range that it is limited to.
    void apply(SetupTriangle& triangle) const;

  private:
    PolygonOffset offset_;
    double step_ = 0;  ///< in q; 0: that of floats
};

}  // namespace ink::raster
