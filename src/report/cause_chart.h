#pragma once

#include <vector>

#include "experiment/summary/cause_totals.h"
#include "report/svg.h"

namespace ink::report {

/// Where the error goes: a stacked bar per method of what it missed, as shares of the true pixels,
/// and one of what it drew wrongly, as shares of the drawn pixels; both on one scale. Grey is what
/// was lost or left over beside a line that was found, each cause of the rest has its colour.
[[nodiscard]] Svg cause_chart(const std::vector<experiment::CauseTotals>& totals);

}  // namespace ink::report
