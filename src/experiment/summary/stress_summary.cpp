#include "experiment/summary/stress_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "core/text_table.h"
#include "experiment/summary/summary.h"
#include "harness/tables/csv.h"
#include "harness/tables/table_of.h"
#include "statistics/bootstrap.h"
#include "studies/stress/stress_axes.h"

namespace ink::experiment {
namespace {

/// An error that moves by less than this is called level.
constexpr double kLevel = 0.02;

/// ".123": an error or a share, without its 0.
std::string share(double value) {
    std::string text = fmt::format("{:.2f}", value);
    return text.starts_with("0") ? text.substr(1) : text;
}

void add_scores(const std::vector<const studies::StressRow*>& rows,
                std::uint64_t seed,
                StressPointSummary& point) {
    std::vector<score::CurveCount> clusters;
    score::CurveCount all{};
    for (const studies::StressRow* row : rows) {
        point.counts.add(row->counts);
        if (!row->row.is_ok()) continue;
        const score::CurveCount counts = counts_2px(row->row);
        clusters.push_back(counts);
        all.k += counts.k;
        all.n_pred += counts.n_pred;
        all.n_truth += counts.n_truth;
    }
    point.cases = static_cast<int>(clusters.size());
    if (clusters.empty()) return;
    point.f = all.f();
    point.f_range = statistics::f_interval(clusters, {.seed = seed});
    const auto k = static_cast<double>(all.k);
    if (all.n_pred > 0) point.precision = k / static_cast<double>(all.n_pred);
    if (all.n_truth > 0) point.recall = k / static_cast<double>(all.n_truth);
    point.truth_px = all.n_truth;
}

using P = StressPointSummary;

harness::TableOf<P> make_points_table() {
    harness::TableOf<P> table(
        "stress_summary.csv",
        "A line per axis, value and method, over its cases: a point of a curve.");
    table.add_derived({"axis", "", "what grows"}, &P::axis);
    table.add_derived({"value", "of unit", "where on the axis"}, &P::value);
    table.add_derived({"unit", "", "of value; empty for a pure number"}, &P::unit);
    table.add_derived({"method", "", "as in rows.csv"}, &P::method);
    table.add_derived({"cases", "", "that have a score"}, &P::cases);
    table.add_derived({"f", "0..1", "F within 2 px of the counts of all cases"}, &P::f);
    const auto range = table.part(&P::f_range);
    range.add_derived({"f_lo", "0..1", "lower end of its 95 % interval, cases resampled"},
                      &statistics::Interval::low);
    range.add_derived({"f_hi", "0..1", "upper end"}, &statistics::Interval::high);
    table.add_derived({"error", "0..1", "1 - f"}, &P::error);
    table.add_derived({"precision", "0..1", "pooled, within 2 px"}, &P::precision);
    table.add_derived({"recall", "0..1", "pooled, within 2 px"}, &P::recall);
    table.add_derived({"truth_px", "px", "true pixels of all cases"}, &P::truth_px);
    using C = studies::StressCounts;
    const auto counts = table.part(&P::counts);
    counts.add_derived({"non_finite", "", "numbers that are NaN or infinite"}, &C::non_finite);
    counts.add_derived({"overflow", "", "codes that overflowed"}, &C::overflow);
    counts.add_derived({"lost_cells", "", "cases without a result"}, &C::lost);
    counts.add_derived({"differing", "", "images that differ where the axis allows none to"},
                       &C::differing);
    return table;
}

const harness::TableOf<P>& points_table() {
    static const harness::TableOf<P> kTable = make_points_table();
    return kTable;
}

}  // namespace

std::optional<double> StressPointSummary::error() const {
    if (!f) return std::nullopt;
    return 1 - *f;
}

std::vector<StressPointSummary> summarise_stress(const std::vector<studies::StressRow>& rows,
                                                 std::uint64_t seed) {
    using Key = std::tuple<std::string, double, std::string>;
    std::map<Key, std::vector<const studies::StressRow*>> groups;
    std::vector<Key> order;
    for (const studies::StressRow& row : rows) {
        const Key key{row.axis, row.value, row.row.method};
        auto& group = groups[key];
        if (group.empty()) order.push_back(key);
        group.push_back(&row);
    }
    std::vector<StressPointSummary> points;
    for (const Key& key : order) {
        const std::vector<const studies::StressRow*>& group = groups[key];
        StressPointSummary point;
        std::tie(point.axis, point.value, point.method) = key;
        point.unit = group.front()->unit;
        add_scores(group, seed, point);
        points.push_back(std::move(point));
    }
    return points;
}

const harness::TableInfo& stress_summary_table() {
    return points_table().info();
}

std::string stress_summary_csv(const std::vector<StressPointSummary>& points) {
    return points_table().file(points);
}

const StressPointSummary* StressCurve::best() const {
    const StressPointSummary* found = nullptr;
    for (const StressPointSummary& point : points) {
        if (point.f && (found == nullptr || *point.f > *found->f)) found = &point;
    }
    return found;
}

const StressPointSummary* StressCurve::worst() const {
    const StressPointSummary* found = nullptr;
    for (const StressPointSummary& point : points) {
        if (point.f && (found == nullptr || *point.f < *found->f)) found = &point;
    }
    return found;
}

double StressCurve::loss() const {
    return best() == nullptr ? 0 : *best()->f - *worst()->f;
}

std::vector<StressCurve> stress_curves(const std::vector<StressPointSummary>& points,
                                       const std::string& axis) {
    std::vector<StressCurve> curves;
    for (const StressPointSummary& point : points) {
        if (point.axis != axis) continue;
        auto at = std::find_if(curves.begin(), curves.end(), [&](const StressCurve& curve) {
            return curve.method == point.method;
        });
        if (at == curves.end()) {
            curves.push_back({point.method, {}});
            at = curves.end() - 1;
        }
        at->points.push_back(point);
    }
    for (StressCurve& curve : curves) {
        std::stable_sort(curve.points.begin(), curve.points.end(), [](auto& a, auto& b) {
            return a.value < b.value;
        });
    }
    return curves;
}

std::string format_stress_value(const studies::StressAxis& axis, double value) {
    for (std::size_t i = 0; i < axis.value_names.size(); ++i) {
        if (axis.values[i] == value) return axis.value_names[i];
    }
    const bool is_plain = value == 0 || (value >= 1e-3 && value < 1e5);
    const std::string text = is_plain ? fmt::format("{:.4g}", value) : fmt::format("{:.1e}", value);
    if (axis.unit.empty()) return text;
    if (axis.unit == "%") return text + " %";
    if (axis.unit == "deg") return text + "°";
    return text + " " + axis.unit;
}

std::string stress_table(const std::vector<StressPointSummary>& points) {
    core::Cells cells = {{"axis",
                          "points",
                          "loses most",
                          "from",
                          "to",
                          "at",
                          "level",
                          "non-finite",
                          "overflow",
                          "lost",
                          "differing"}};
    for (const studies::StressAxis& axis : studies::stress_axes()) {
        const std::vector<StressCurve> curves = stress_curves(points, axis.name);
        if (curves.empty()) continue;
        const StressCurve* worst = nullptr;
        studies::StressCounts counts;
        int level = 0;
        for (const StressCurve& curve : curves) {
            for (const StressPointSummary& point : curve.points)
                counts.add(point.counts);
            if (harness::is_baseline(curve.method) || curve.best() == nullptr) continue;
            level += curve.loss() < kLevel ? 1 : 0;
            if (worst == nullptr || curve.loss() > worst->loss()) worst = &curve;
        }
        cells.push_back({axis.name,
                         std::to_string(curves.front().points.size()),
                         worst == nullptr ? "–" : worst->method,
                         worst == nullptr ? "–" : share(*worst->best()->error()),
                         worst == nullptr ? "–" : share(*worst->worst()->error()),
                         worst == nullptr ? "–" : format_stress_value(axis, worst->worst()->value),
                         std::to_string(level),
                         std::to_string(counts.non_finite),
                         std::to_string(counts.overflow),
                         std::to_string(counts.lost),
                         std::to_string(counts.differing)});
    }
    return core::aligned(cells);
}

const harness::TableInfo& stress_axes_table() {
    static const harness::TableInfo table{
        "stress_axes.csv",
        "A line per axis of stress.csv: what it varies.",
        {{"axis", "", "as in stress.csv"},
         {"title", "", "what its values are"},
         {"unit", "", "of its values; empty for a pure number"},
         {"is_log", "", "true: values lie on a logarithmic scale"},
         {"sentence", "", "what is varied, and what stays"},
         {"value_names", "", "of named values 1, 2, 3 and so on, a;b;c; empty for numbers"}}};
    return table;
}

std::string stress_axes_csv(const std::vector<studies::StressRow>& rows) {
    std::string text = harness::heading(stress_axes_table());
    for (const studies::StressAxis& axis : studies::stress_axes()) {
        const bool is_there = std::any_of(
            rows.begin(), rows.end(), [&](const auto& row) { return row.axis == axis.name; });
        if (!is_there) continue;
        text +=
            fmt::format("{},{},{},{},{},{}\n",
                        axis.name,
                        harness::csv_field(axis.title),
                        harness::csv_field(axis.unit),
                        axis.scale == studies::AxisScale::log,
                        harness::csv_field(axis.sentence),
                        harness::csv_field(fmt::format("{}", fmt::join(axis.value_names, ";"))));
    }
    return text;
}

}  // namespace ink::experiment
