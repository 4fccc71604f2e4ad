#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "raster/mesh/lane_triangles.h"

namespace ink::raster {

/// Looks up the corners of at most LaneTriangles::kCount listed triangles, none of them of the
/// scalar path, with `values` values each: fills out.corners, whose last vector has numbers without
/// meaning in it, and out.constants if there are any.
void collect_corners(const LaneSource& source,
                     std::size_t values,
                     bool has_constants,
                     std::span<const std::uint32_t> entries,
                     LaneTriangles& out);

}  // namespace ink::raster
