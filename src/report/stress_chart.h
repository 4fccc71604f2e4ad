#pragma once

#include <vector>

#include "experiment/summary/stress_summary.h"
#include "report/svg.h"
#include "studies/stress/stress_axes.h"

namespace ink::report {

/// Error 1 - F at 2 px against the value of an axis: a panel per family of the registry
/// and one for others if there are any, a line per method with
/// whiskers at its 95 % intervals, its name at its end; tuned rows dashed in the colour of their
/// base. Dotted: the ceiling (`sampled`). The same error scale in all panels.
[[nodiscard]] Svg stress_chart(const studies::StressAxis& axis,
                               const std::vector<experiment::StressCurve>& curves);

}  // namespace ink::report
