#pragma once

#include <vector>

#include "scene/box.h"
#include "scene/topology.h"

namespace ink::scene {

/// What is smaller than this on the image cannot be seen there. A gap below it, and within the weld
/// tolerance of its object, is a defect of the mesh and no line (section 5 of the design).
inline constexpr double kUnseen_px = 1.0 / 64;

/// Per object the box round it. Indexed by Face::object; none beyond the last that has faces.
[[nodiscard]] std::vector<Box> object_boxes(const Topology& topology);

/// Per object the distance, world units, within which its surface counts as one: 1e-6 of the
/// diagonal of the box round it, and no less than what rounding may have done to two of its
/// vertices. Indexed as object_boxes; 0 for an object without faces.
[[nodiscard]] std::vector<double> weld_tolerances(const Topology& topology);

}  // namespace ink::scene
