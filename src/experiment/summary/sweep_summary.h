#pragma once

#include <string>
#include <vector>

#include "harness/row.h"

namespace ink::experiment {

/// One setting of a method, over all views on which it was drawn.
struct SettingSummary {
    std::string difference;  ///< from the method's setting in this run: "fatten=true"; "" if none
    double draw_ms = 0;      ///< median over views
    double error = 0;        ///< 1 - F of the pooled counts at 2 px

    [[nodiscard]] bool is_default() const { return difference.empty(); }
};

/// The settings of one method.
struct MethodSweep {
    std::string method;
    std::vector<SettingSummary> settings;  ///< in the order of the rows; at least one
};

/// A summary per method of `sweep` (rows of sweep.csv), in the order of its rows; `rows` (of
/// rows.csv) hold the settings that count as the methods' own. Rows that failed are left out, as
/// are settings without a time or a score.
[[nodiscard]] std::vector<MethodSweep> summarise_sweep(const std::vector<harness::Row>& rows,
                                                       const std::vector<harness::Row>& sweep);

}  // namespace ink::experiment
