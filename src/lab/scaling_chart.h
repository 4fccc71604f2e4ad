#pragma once

#include <vector>

#include "lab/scaling.h"
#include "lab/svg.h"

namespace ink::lab {

/// Least time of a frame against one axis, both logarithmic: a line per method with its name at its
/// right end, and a dashed guide of slope 1, along which cost is linear. An axis without points
/// says so.
[[nodiscard]] Svg scaling_chart(ScalingAxis axis, const std::vector<ScalingPoint>& points);

}  // namespace ink::lab
