#pragma once

#include <set>
#include <utility>

#include "raster/pass/screen_vertex.h"

namespace ink::raster {

/// A pixel of the image, (x, y).
using Pixel = std::pair<int, int>;

/// The pixels of a line, found one by one from OpenGL's own words (specification 2.1,
/// sections 3.4.1 and 3.4.2.1) and sharing nothing with LineSteps: a fragment is produced if the
/// segment, moved by
/// (-e, -e^2), meets its open diamond and does not end there. For widths above 1 columns (or rows)
/// are those of width 1, and in each w fragments are produced instead of one, the first where the
/// segment, moved by (w-1)/2 and prolonged, has its own. Ends in 1/256 px of the image, within a
/// few hundred px of its origin.
std::set<Pixel> reference_line(const ScreenVertex& a, const ScreenVertex& b, int width_px);

}  // namespace ink::raster
