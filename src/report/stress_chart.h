#pragma once

#include <string>
#include <vector>

#include "experiment/stress_summary.h"
#include "report/svg.h"
#include "studies/stress/stress_axes.h"

namespace ink::report {

/// What methods have in common: a panel of its own on every chart.
enum class StressFamily { full_buffers, packed, object_space, ids };

/// The family of a method; a tuned row is of its base's. One that no list names stands with `ids`,
/// whose panel is headed "ids and others".
[[nodiscard]] StressFamily stress_family(const std::string& method);

/// Error 1 - F at 2 px against the value of an axis: a panel per family, a line per method with
/// whiskers at its 95 % intervals, its name at its end; tuned rows dashed in the colour of their
/// base. Dotted: the ceiling (`sampled`). The same error scale in all panels.
[[nodiscard]] Svg stress_chart(const studies::StressAxis& axis,
                               const std::vector<experiment::StressCurve>& curves);

}  // namespace ink::report
