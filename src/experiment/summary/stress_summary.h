#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "harness/tables/table.h"
#include "statistics/spread.h"
#include "studies/stress/stress_rows.h"

namespace ink::experiment {

/// One method at one value of one axis, over its cases: a point of a curve.
struct StressPointSummary {
    std::string axis;
    double value = 0;
    std::string unit;
    std::string method;
    int cases = 0;                                     ///< without failure
    std::optional<double> f;                           ///< at 2 px, of the counts pooled over cases
    std::optional<statistics::Interval> f_range = {};  ///< 95 %, cases resampled; two at least
    std::optional<double> precision = {};
    std::optional<double> recall = {};
    std::int64_t truth_px = 0;
    studies::StressCounts counts = {};

    [[nodiscard]] std::optional<double> error() const;
};

/// A point per axis, value and method, in the order of the rows.
[[nodiscard]] std::vector<StressPointSummary> summarise_stress(
    const std::vector<studies::StressRow>& rows, std::uint64_t seed);

/// The columns of stress_summary.csv.
[[nodiscard]] const harness::TableInfo& stress_summary_table();

/// stress_summary.csv, heading and line breaks included.
[[nodiscard]] std::string stress_summary_csv(const std::vector<StressPointSummary>& points);

/// stress_axes.csv: what each axis of the rows varies, for who reads its values.
[[nodiscard]] const harness::TableInfo& stress_axes_table();
[[nodiscard]] std::string stress_axes_csv(const std::vector<studies::StressRow>& rows);

/// The points of one method on one axis, by value.
struct StressCurve {
    std::string method;
    std::vector<StressPointSummary> points;

    /// By how much its error differs between its best and its worst point; 0 with fewer than two.
    [[nodiscard]] double loss() const;
    [[nodiscard]] const StressPointSummary* best() const;   ///< null without a point
    [[nodiscard]] const StressPointSummary* worst() const;  ///< null without a point
};

/// The curves of an axis in the order of their methods, baselines among them.
[[nodiscard]] std::vector<StressCurve> stress_curves(const std::vector<StressPointSummary>& points,
                                                     const std::string& axis);

/// A value of an axis as people read it: "1e-07", "20 deg", "zbuffer16 z16".
[[nodiscard]] std::string format_stress_value(const studies::StressAxis& axis, double value);

/// For a terminal: a line per axis with the method that loses most, and the counts.
[[nodiscard]] std::string stress_table(const std::vector<StressPointSummary>& points);

}  // namespace ink::experiment
