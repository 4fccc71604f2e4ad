#pragma once

#include "raster/mesh/lane_triangles.h"

namespace ink::raster {

/// Finds, for triangles that are set up, the columns of vectors that fill_lanes draws, and which of
/// their rows each triangle may cover: LaneTriangles::first_x and rows.
void find_rows(LaneTriangles& triangles);

}  // namespace ink::raster
