#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiment/summary/summary.h"
#include "harness/row.h"
#include "statistics/spread.h"

namespace ink::experiment {

/// One setting of a method, over all views on which it was drawn.
struct SettingSummary {
    std::string difference;  ///< from the method's setting in this run: "fatten=true"; "" if none
    std::string params;      ///< every parameter
    double draw_ms = 0;      ///< median over views
    std::optional<statistics::Interval> draw_ms_quartiles;
    double error = 0;                                 ///< 1 - F of the pooled counts at 2 px
    std::optional<statistics::Interval> error_range;  ///< 95 %, cluster bootstrap

    [[nodiscard]] bool is_default() const { return difference.empty(); }
};

/// The settings of one method and which of them no other of its settings beats in both.
struct MethodSweep {
    std::string method;
    std::vector<SettingSummary> settings;
    std::vector<std::size_t> front;  ///< indices into `settings`, from the fastest to the best
};

/// What error against time is drawn from, all over the same views.
struct Fronts {
    std::vector<MethodSweep> methods;      ///< in the order of the rows; at least a setting each
    std::vector<MethodSummary> baselines;  ///< none, sampled, oracle on those views
    int views = 0;
    int scenes = 0;
    bool is_swept = false;  ///< else every method has its one setting
};

/// The fronts over `sweep` (rows of sweep.csv), with the baselines of `rows` on the sweep's views;
/// over `rows` themselves if there is no sweep. Rows that failed are left out, as are methods
/// without a time or a score.
[[nodiscard]] Fronts summarise_fronts(const std::vector<harness::Row>& rows,
                                      const std::vector<harness::Row>& sweep);

}  // namespace ink::experiment
