#pragma once

#include <cstdint>

namespace ink::raster {

/// Format of a pass's depth test. Always: larger is nearer, 0 is infinity, equal does not replace.
enum class DepthFormat {
    q32,  ///< q = 1/w rounded to float
    z24,  ///< window depth, near 2^24-1 .. far 0, rounded to 24 bits as OpenGL stores it, near =
          ///< high
    z16,  ///< the same in 16 bits
};

/// How a *method* writes depth into a buffer it filters: an axis of the testbed, not a detail.
///
/// All are scaled to 0..1, 0 at `far`, 1 at `near` of the range in use, and continue beyond it.
enum class DepthEncoding {
    inverse,         ///< 1/w: affine on screen, so a plane's Laplacian is 0
    linear,          ///< w
    log,             ///< log w
    zbuffer24,       ///< OpenGL's hyperbolic window depth, 24-bit steps
    zbuffer16,       ///< the same, 16-bit steps
    reversed_float,  ///< near / w as a float with a 0 at infinity
};

/// The distances between which an encoding runs from 0 to 1.
struct DepthRange {
    double near = 0;  ///< > 0
    double far = 0;   ///< > near
    /// Of a parallel camera, under which `linear` and `log` are `inverse`.
    bool is_parallel = false;
};

/// `encoding` of distance `w` > 0: 1 at range.near, 0 at range.far (reversed_float: near/far
/// there). w = infinity gives the limit: finite for inverse, zbuffer* and reversed_float, -infinity
/// else.
[[nodiscard]] double encode_depth(DepthEncoding encoding, double w, const DepthRange& range);

/// Rounds q = 1/w to the whole steps of z24 or z16: with d = (1/near - q) / (1/near - 1/far)
/// OpenGL's window depth, max - d * max to the nearest, at least 1.
class QuantisedDepth {
  public:
    /// `near` and `far` are not looked at for q32.
    QuantisedDepth(DepthFormat format, double near, double far);

    [[nodiscard]] std::uint32_t of(double q) const {
        const double z = q * scale_ + offset_;  // the half of rounding is in the offset
        if (!(z >= 1)) return 1;
        return z >= steps_ ? static_cast<std::uint32_t>(steps_) : static_cast<std::uint32_t>(z);
    }

    /// 1/w of a step: what it stands for, to half of one. Not of q32.
    [[nodiscard]] double q_of(std::uint32_t step) const { return (step + 0.5 - offset_) / scale_; }

    /// The parts of that sum, for who does many at once.
    [[nodiscard]] double scale() const { return scale_; }
    [[nodiscard]] double offset() const { return offset_; }
    [[nodiscard]] double steps() const { return steps_; }

  private:
    double steps_;
    double scale_ = 0;
    double offset_ = 0;
};

}  // namespace ink::raster
