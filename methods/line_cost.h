#pragma once

#include "methods/cost.h"

namespace ink::methods {

/// A pass over the triangles that fills a frame's depth, which lines are tested against afterwards.
///
/// The lines themselves are not in it: they cost by their length on the screen, which hangs on
/// scene and view, and no Cost knows them.
[[nodiscard]] Cost filled_lines_cost(const raster::PassFormat& format);

}  // namespace ink::methods
