#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiment/summary/summary.h"
#include "report/svg.h"
#include "statistics/spread.h"

namespace ink::report {

/// A method on the chart.
struct TimedError {
    std::string method;
    double draw_ms = 0;  ///< above 0
    std::optional<statistics::Interval> draw_ms_range = {};
    double error = 0;  ///< 0..1
    std::optional<statistics::Interval> error_range = {};
};

/// The methods of `summaries` that were both scored and timed: error 1 - F at 2 px of the pooled
/// counts with its 95 % interval, median time with its quartiles.
[[nodiscard]] std::vector<TimedError> timed_errors(
    const std::vector<experiment::MethodSummary>& summaries);

/// Error in per cent against draw time in ms for the column of a paper, 560 x 470 units: both axes
/// logarithmic, a marker (method_looks.h) with its label and both intervals per method, the Pareto
/// front as a grey stair, and the error of `sampled`, if known, as a dotted line. An error below
/// the plot (0 has no logarithm) stands on its lower edge. Labels cover neither each other nor
/// markers as long as there is room. An empty chart says so.
[[nodiscard]] Svg error_time_chart(const std::vector<TimedError>& points,
                                   std::optional<double> sampled_error);

}  // namespace ink::report
