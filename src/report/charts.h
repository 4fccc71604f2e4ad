#pragma once

#include <vector>

#include "experiment/summary/summary.h"
#include "experiment/summary/sweep_summary.h"
#include "report/svg.h"

namespace ink::report {

/// Error 1 - F at 2 px against draw time, both logarithmic. Per method: a small point per
/// setting of its sweep, a stair along those that no other of its settings beats in both, and its
/// own setting as a large marker with its 95 % interval (error) and its quartiles over views
/// (time). Floor, ceiling and the random baseline are lines across, or notes at the top where they
/// lie above. An empty chart says so.
[[nodiscard]] Svg front_chart(const experiment::Fronts& fronts);

/// Recall per line class at 2 px: a panel per class, a bar per method and for `sampled`, with the
/// 95 % intervals that `rows` (those of the summaries) give.
[[nodiscard]] Svg class_chart(const std::vector<experiment::MethodSummary>& summaries,
                              const std::vector<harness::Row>& rows);

}  // namespace ink::report
