#pragma once

#include <vector>

#include "report/svg.h"
#include "studies/scaling.h"

namespace ink::report {

/// Least time of a frame against one axis, both logarithmic: a line per method with its name at its
/// right end, and a dashed guide of slope 1, along which cost is linear. An axis without points
/// says so.
[[nodiscard]] Svg scaling_chart(studies::ScalingAxis axis,
                                const std::vector<studies::ScalingPoint>& points);

}  // namespace ink::report
