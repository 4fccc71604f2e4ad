#include "studies/axis_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <tuple>

#include "core/text_table.h"
#include "statistics/bootstrap.h"
#include "studies/axis.h"

namespace ink::studies {
namespace {

/// An error that moves by less than this is called level.
constexpr double kLevel = 0.02;

/// ".123": an error or a share, without its 0.
std::string share(double value) {
    std::string text = fmt::format("{:.2f}", value);
    return text.starts_with("0") ? text.substr(1) : text;
}

void add_scores(const std::vector<const AxisRow*>& rows, std::uint64_t seed, AxisPoint& point) {
    std::vector<score::CurveCount> clusters, inks;
    score::CurveCount all{};
    for (const AxisRow* row : rows) {
        point.faults.add(row->faults);
        if (!row->row.is_ok()) continue;
        const score::CurveCount counts{row->row.k_2px, row->row.n_pred, row->row.n_truth};
        clusters.push_back(counts);
        all += counts;
        if (!row->row.soft) continue;
        if (!point.soft) point.soft.emplace();
        *point.soft += *row->row.soft;
        inks.push_back(row->row.soft->counts());
    }
    point.cases = static_cast<int>(clusters.size());
    if (clusters.empty()) return;
    point.f = all.f();
    point.f_range = statistics::f_interval(clusters, {.seed = seed});
    point.soft_range = statistics::f_interval(inks, {.seed = seed});
    point.truth_px = all.n_truth;
}

/// The point whose F comes before that of all others; null if none has one.
template <class Before>
const AxisPoint* first_of(const std::vector<AxisPoint>& points, Before before) {
    const AxisPoint* found = nullptr;
    for (const AxisPoint& point : points) {
        if (point.f && (found == nullptr || before(*point.f, *found->f))) found = &point;
    }
    return found;
}

/// A method's curve that loses most, and along which axis.
struct Break {
    std::string method;
    const Axis* axis = nullptr;
    AxisCurve curve;

    [[nodiscard]] bool is_level() const { return curve.loss() < kLevel; }
};

/// Of each method, the axis that it loses most along; who loses most first.
std::vector<Break> breaks_of(const std::vector<AxisPoint>& points) {
    std::vector<Break> breaks;
    for (const Axis& axis : stress_axes()) {
        for (AxisCurve& curve : axis_curves(points, axis.name)) {
            if (harness::is_baseline(curve.method) || curve.best() == nullptr) continue;
            auto known = std::ranges::find(breaks, curve.method, &Break::method);
            if (known == breaks.end()) known = breaks.insert(known, {curve.method, &axis, {}});
            if (curve.loss() > known->curve.loss() || known->curve.points.empty())
                *known = {curve.method, &axis, std::move(curve)};
        }
    }
    std::ranges::stable_sort(
        breaks, std::greater<>(), [](const Break& b) { return b.curve.loss(); });
    return breaks;
}

/// "grazing breaks mote4 first (error .02 to .45 at 2°)".
std::string break_text(const Break& of) {
    return fmt::format("{} breaks {} first (error {} to {} at {})",
                       of.axis->name,
                       of.method,
                       share(*of.curve.best()->error()),
                       share(*of.curve.worst()->error()),
                       format_value(*of.axis, of.curve.worst()->value));
}

}  // namespace

std::optional<double> AxisPoint::error() const {
    if (!f) return std::nullopt;
    return 1 - *f;
}

std::vector<AxisPoint> summarise_axes(const std::vector<AxisRow>& rows) {
    using Key = std::tuple<std::string, double, std::string>;
    std::map<Key, std::vector<const AxisRow*>> groups;
    std::vector<Key> order;
    for (const AxisRow& row : rows) {
        const Key key{row.row.axis, *row.row.value, row.row.method};
        auto& group = groups[key];
        if (group.empty()) order.push_back(key);
        group.push_back(&row);
    }
    std::vector<AxisPoint> points;
    for (const Key& key : order) {
        const std::vector<const AxisRow*>& group = groups[key];
        AxisPoint point;
        std::tie(point.axis, point.value, point.method) = key;
        add_scores(group, rows.front().row.seed, point);
        points.push_back(std::move(point));
    }
    return points;
}

core::TableOf<AxisPoint> axis_summary_table(bool has_ink) {
    using P = AxisPoint;
    core::TableOf<P> table(
        "axis_summary.csv",
        "A line per axis, value and method, over its cases: a point of a curve.");
    table.add_derived({"axis", "", "what grows"}, &P::axis);
    table.add_derived({"value", "of axis", "where on the axis"}, &P::value);
    table.add_derived({"method", "", "as in rows.csv"}, &P::method);
    table.add_derived({"cases", "", "that have a score"}, &P::cases);
    table.add_derived({"f", "0..1", "F within 2 px of the counts of all cases"}, &P::f);
    const auto range = table.part(&P::f_range);
    range.add_derived({"f_lo", "0..1", "lower end of its nominal 95 % interval, cases resampled"},
                      &statistics::Interval::low);
    range.add_derived({"f_hi", "0..1", "upper end"}, &statistics::Interval::high);
    table.add_derived({"truth_px", "px", "true pixels of all cases"}, &P::truth_px);
    using C = CaseFaults;
    if (has_ink) {
        table.part(&P::soft).add_derived(
            {"soft_f", "0..1", "of the ink of all cases; only with --coverage"},
            &score::SoftScore::f);
        const auto soft_range = table.part(&P::soft_range);
        soft_range.add_derived({"soft_lo", "0..1", "lower end of its nominal 95 % interval"},
                               &statistics::Interval::low);
        soft_range.add_derived({"soft_hi", "0..1", "upper end"}, &statistics::Interval::high);
    }
    const auto counts = table.part(&P::faults);
    counts.add_derived({"non_finite", "", "numbers that are NaN or infinite"}, &C::non_finite);
    counts.add_derived({"overflow", "", "codes that overflowed"}, &C::overflow);
    counts.add_derived({"lost_cells", "", "cases without a result"}, &C::lost);
    counts.add_derived({"differing", "", "images that differ where the axis allows none to"},
                       &C::differing);
    return table;
}

std::string axis_summary_csv(const std::vector<AxisPoint>& points) {
    const bool has_ink =
        std::ranges::any_of(points, [](const auto& p) { return p.soft.has_value(); });
    return axis_summary_table(has_ink).file(points);
}

const AxisPoint* AxisCurve::best() const {
    return first_of(points, std::greater<>());
}

const AxisPoint* AxisCurve::worst() const {
    return first_of(points, std::less<>());
}

double AxisCurve::loss() const {
    return best() == nullptr ? 0 : *best()->f - *worst()->f;
}

std::vector<AxisCurve> axis_curves(const std::vector<AxisPoint>& points, const std::string& axis) {
    std::vector<AxisCurve> curves;
    for (const AxisPoint& point : points) {
        if (point.axis != axis) continue;
        auto at = std::ranges::find(curves, point.method, &AxisCurve::method);
        if (at == curves.end()) {
            curves.push_back({point.method, {}});
            at = curves.end() - 1;
        }
        at->points.push_back(point);
    }
    for (AxisCurve& curve : curves) {
        std::ranges::stable_sort(curve.points, {}, &AxisPoint::value);
    }
    return curves;
}

Finding stress_finding(const std::vector<AxisPoint>& points) {
    constexpr std::size_t kTold = 3;  ///< methods that a heading has room for
    const std::vector<Break> breaks = breaks_of(points);
    if (breaks.empty()) return {};
    std::map<std::string, std::size_t> count_of_axis;
    std::vector<std::string> told, level;
    for (const Break& of : breaks) {
        if (of.is_level()) {
            level.push_back(of.method);
            continue;
        }
        told.push_back(break_text(of));
        ++count_of_axis[of.axis->name];
    }
    if (!level.empty()) told.push_back(fmt::format("no axis breaks {}", fmt::join(level, ", ")));
    const std::string all = fmt::format("{}", fmt::join(told, "; "));
    const char* rule = "First is the axis along which a method's error grows most.";
    if (breaks.size() <= kTold) return {all, rule};
    const auto most = std::ranges::max_element(
        count_of_axis, {}, &std::pair<const std::string, std::size_t>::second);
    return {most == count_of_axis.end()
                ? fmt::format("No axis breaks any of {} methods", breaks.size())
                : fmt::format(
                      "{} breaks {} of {} methods first", most->first, most->second, breaks.size()),
            fmt::format("{} {}.", rule, all)};
}

std::string stress_table(const std::vector<AxisPoint>& points) {
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
    for (const Axis& axis : stress_axes()) {
        const std::vector<AxisCurve> curves = axis_curves(points, axis.name);
        if (curves.empty()) continue;
        const AxisCurve* worst = nullptr;
        CaseFaults faults;
        int level = 0;
        for (const AxisCurve& curve : curves) {
            for (const AxisPoint& point : curve.points)
                faults.add(point.faults);
            if (harness::is_baseline(curve.method) || curve.best() == nullptr) continue;
            level += curve.loss() < kLevel ? 1 : 0;
            if (worst == nullptr || curve.loss() > worst->loss()) worst = &curve;
        }
        cells.push_back({axis.name,
                         std::to_string(curves.front().points.size()),
                         worst == nullptr ? "–" : worst->method,
                         worst == nullptr ? "–" : share(*worst->best()->error()),
                         worst == nullptr ? "–" : share(*worst->worst()->error()),
                         worst == nullptr ? "–" : format_value(axis, worst->worst()->value),
                         std::to_string(level),
                         std::to_string(faults.non_finite),
                         std::to_string(faults.overflow),
                         std::to_string(faults.lost),
                         std::to_string(faults.differing)});
    }
    return cells.size() == 1 ? "" : core::aligned(cells);
}

}  // namespace ink::studies
