#pragma once

#include <span>

#include "truth/curve.h"

namespace ink::truth {

/// Between which neighbouring pixel centres the curves run: the truth's second product, which no
/// thinning touches.
///
/// Decided exactly, for curves at any double positions. A curve that runs through a centre leaves
/// it on one side, the same for all its four segments: every centre counts as lying a little to the
/// right of where it is, and by far less below it. So a line straight down through centres runs to
/// the left of them, a level one above them, and any other one as if it were moved to the left.
/// Where one curve ends another begins in the same point, the two together cross what one curve
/// through both would cross, no segment twice and none left out; a closed line crosses a closed
/// ring of segments an even number of times.
///
/// Costs about the length of the curves. Curves may lie outside the image in part or whole. An
/// empty image gives empty images.
[[nodiscard]] Cracks draw_cracks(std::span<const Curve> curves, int width_px, int height_px);

}  // namespace ink::truth
