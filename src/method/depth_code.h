#pragma once

#include <limits>

#include "raster/depth/depth.h"
#include "raster/pass/pass.h"
#include "scene/camera.h"

namespace ink::method {

/// Where a depth encoding's 0 and 1 come from.
enum class RangeSource {
    fit,     ///< the extent of the scene's bounding sphere along the view direction
    camera,  ///< the camera's near and far
};

/// The distances between which depth runs from 1 to 0 on one view. Both positive, near < far,
/// whatever the sphere: one wholly behind the eye gives the camera's range.
///
/// `fit` is centre distance -+ radius, near no less than the camera's: nothing nearer is drawn, so
/// whatever is drawn has a depth of 0..1 and no code built to fit can overflow.
[[nodiscard]] raster::DepthRange depth_range(RangeSource source,
                                             const scene::Camera& camera,
                                             const scene::Sphere& bounds);

/// What DepthCarrier writes where nothing was drawn, in the f32 plane that carries depth.
inline constexpr float kNothingDrawn = std::numeric_limits<float>::lowest();

/// Encoded depths stay within -+ this, so that a code computed from one fits a fixed-point plane.
inline constexpr double kDepthLimit = 1024;

/// encode_depth within the limit.
[[nodiscard]] double encode_limited(raster::DepthEncoding encoding,
                                    double w,
                                    const raster::DepthRange& range);

/// Depth on its way through an f32 interpolant: exact at every pixel, in any encoding.
///
/// What is interpolated is not the encoded depth but what the interpolation carries exactly: 1/w
/// where it is affine on the screen, w where it is perspective. Pixels encode it afterwards; for
/// the encodings that are affine in 1/w there is then nothing left to do.
class DepthCarrier {
  public:
    DepthCarrier(raster::DepthEncoding encoding,
                 raster::Interpolation interpolation,
                 const raster::DepthRange& range);

    /// The interpolant of a vertex at distance w > 0.
    [[nodiscard]] float at_vertex(double w) const;

    /// Whether 1/w is what it carries, else w.
    [[nodiscard]] bool is_affine() const { return interpolation_ == raster::Interpolation::affine; }

    /// Whether the interpolated value is the encoded depth as it stands.
    [[nodiscard]] bool is_encoded() const;

    /// The encoded depths of `count` interpolated values, `sky` where nothing was drawn.
    void encode_row(const float* carried, float sky, float* encoded, int count) const;

  private:
    raster::DepthEncoding encoding_;
    raster::Interpolation interpolation_;
    raster::DepthRange range_;
};

}  // namespace ink::method
