#pragma once

#include <span>

#include "core/image.h"
#include "truth/curve.h"

namespace ink::score {

/// How wide true lines are drawn unless another width is asked for. The filters of one sample a
/// pixel draw lines of one pixel (Roberts' cross) or two (a Laplacian): 1.5 favours neither.
inline constexpr double kLineWidth_px = 1.5;
inline constexpr double kLeastLineWidth_px = 0.25;
inline constexpr double kMostLineWidth_px = 4;

/// Each pixel's share, 0..1, that a round pen covers which draws the curves `line_width_px` wide:
/// the union of all strokes, so that nothing counts twice where they cross or meet.
///
/// A stroke is all that lies within half the width of its curve; its ends are round, and a curve
/// without a length is a disc. Exact to 1/1000 where lines are wider than half a pixel, else to
/// 1/256; the same for every number of threads. Without curves all is 0. The width is within
/// the limits above.
[[nodiscard]] core::Image<float> draw_coverage(std::span<const truth::Curve> curves,
                                               int width_px,
                                               int height_px,
                                               double line_width_px);

}  // namespace ink::score
