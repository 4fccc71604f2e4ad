#pragma once

#include "method/cost.h"

namespace ink::buffers {

/// A pass over the triangles that fills a frame's depth, which lines are tested against afterwards.
///
/// The lines themselves are not in it: they cost by their length on the screen, which depends on
/// scene and view, and no Cost knows them.
[[nodiscard]] method::Cost filled_lines_cost(const raster::PassFormat& format);

}  // namespace ink::buffers
