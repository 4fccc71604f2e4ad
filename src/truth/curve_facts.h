#pragma once

#include <cstddef>
#include <span>

#include "truth/eye_scene.h"
#include "truth/eye_view.h"
#include "truth/truth.h"

namespace ink::truth {

/// Fills what a traced piece says of its faces and surroundings, at its middle on the image:
/// `face0`, `face1`, `empty_side`, `gap` and `view_angle_rad`.
///
/// Pieces of mesh edges run from the edge's a to its b. One seen from one side only (contour,
/// boundary) has as `face0` the face the eye sees and as `face1` the lowest other one; one seen
/// from both sides (crease, seam) has the face on its left as `face0` and that on its right as
/// `face1`, also where the right one only continues the surface. A piece without a mesh edge keeps
/// its faces and gets their view angle. The gap is that of the nearest face beyond the middle on
/// the line of sight, the edge's own left out, and 0 where that face touches the line.
///
/// Returns the rays that were cast: one a contour or boundary. The same for every thread count.
[[nodiscard]] std::size_t fill_curve_facts(const EyeView& eye,
                                           const EyeScene& scene,
                                           std::span<Curve> curves,
                                           int threads);

/// Visible length of contours by what lies behind them, px.
struct ContourLengths {
    double sky_px = 0;
    double other_object_px = 0;
    double self_px = 0;
};

/// Sums the contours among `curves`; other classes do not count.
[[nodiscard]] ContourLengths contour_lengths(std::span<const Curve> curves);

}  // namespace ink::truth
