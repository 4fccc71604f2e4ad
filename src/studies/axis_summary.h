#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/tables/table_of.h"
#include "statistics/spread.h"
#include "studies/axis_rows.h"

namespace ink::studies {

/// One method at one value of one axis, over its cases: a point of a curve.
struct AxisPoint {
    std::string axis;
    double value = 0;
    std::string method;
    int cases = 0;                                     ///< without failure
    std::optional<double> f;                           ///< at 2 px, of the counts pooled over cases
    std::optional<statistics::Interval> f_range = {};  ///< 95 %, cases resampled; two at least
    std::int64_t truth_px = 0;
    std::optional<score::SoftScore> soft = {};            ///< of grey lines, pooled over cases
    std::optional<statistics::Interval> soft_range = {};  ///< of soft F, as f_range
    CaseFaults faults = {};

    [[nodiscard]] std::optional<double> error() const;
};

/// A point per axis, value and method, in the order of the rows. Intervals are of the first row's
/// seed.
[[nodiscard]] std::vector<AxisPoint> summarise_axes(const std::vector<AxisRow>& rows);

/// axis_summary.csv, with soft F if grey lines are scored.
[[nodiscard]] core::TableOf<AxisPoint> axis_summary_table(bool has_ink);
[[nodiscard]] std::string axis_summary_csv(const std::vector<AxisPoint>& points);

/// The points of one method on one axis, by value.
struct AxisCurve {
    std::string method;
    std::vector<AxisPoint> points;

    /// By how much its error differs between its best and its worst point; 0 with fewer than two.
    [[nodiscard]] double loss() const;
    [[nodiscard]] const AxisPoint* best() const;   ///< null without a point
    [[nodiscard]] const AxisPoint* worst() const;  ///< null without a point
};

/// The curves of an axis in the order of their methods, baselines among them.
[[nodiscard]] std::vector<AxisCurve> axis_curves(const std::vector<AxisPoint>& points,
                                                 const std::string& axis);

/// Which axis breaks which method first: the one along which its error grows most.
struct Finding {
    std::string first;  ///< as a heading: of few methods each, of more how many an axis breaks
    std::string rest;   ///< each method with its axis and its errors
};
/// Empty without a method that has a score.
[[nodiscard]] Finding stress_finding(const std::vector<AxisPoint>& points);

/// For a terminal: a line per axis with the method that loses most, and the counts; "" without
/// stress.
[[nodiscard]] std::string stress_table(const std::vector<AxisPoint>& points);

}  // namespace ink::studies
