#include "summary/paired_differences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "statistics/simultaneous.h"
#include "summary/summary.h"

namespace ink::summary {
namespace {

using Counts = score::CurveCount;

double pooled_f(const std::vector<Counts>& scenes) {
    Counts sum;
    for (const Counts& counts : scenes)
        sum += counts;
    return sum.f();
}

constexpr int kDigits = 3;

/// ".012" or "0.012" with the sign before it.
std::string format_signed(double value, int digits, bool has_zeros) {
    const std::string share = fmt::format("{:.{}f}", std::abs(value), digits);
    const bool drops_zero = !has_zeros && share[0] == '0';
    return fmt::format("{}{}", value < 0 ? '-' : '+', drops_zero ? share.substr(1) : share);
}

/// Whether an interval that ends near 0 still says, so rounded, on which side of 0 it lies.
bool says_side(const statistics::Interval& range, int digits) {
    const double least = 0.5 * std::pow(10.0, -digits);
    return std::abs(range.low) >= least && std::abs(range.high) >= least;
}

std::map<harness::Place, const harness::Row*> rows_by_place(const std::vector<harness::Row>& rows,
                                                            const std::string& method) {
    std::map<harness::Place, const harness::Row*> found;
    for (const harness::Row& row : rows) {
        if (row.method == method && row.is_scored()) found.emplace(harness::place_of(row), &row);
    }
    return found;
}

/// The rows of two methods, view by view.
PairedScenes pair_up(const std::vector<harness::Row>& rows,
                     const std::string& a,
                     const std::string& b,
                     Measure measure) {
    const auto of_b = rows_by_place(rows, b);
    std::vector<RowPair> pairs;
    for (const auto& [where, row] : rows_by_place(rows, a)) {
        const auto other = of_b.find(where);
        if (other != of_b.end()) pairs.push_back({row, other->second});
    }
    return paired_scenes(pairs, measure);
}

PairedDifference difference_of(const std::string& a,
                               const std::string& b,
                               const PairedScenes& scenes) {
    PairedDifference paired{a, b, scenes.f_a() - scenes.f_b(), std::nullopt};
    paired.scenes = static_cast<int>(scenes.names.size());
    for (std::size_t i = 0; i < scenes.names.size(); ++i) {
        paired.better += scenes.a[i].f() > scenes.b[i].f() ? 1 : 0;
        paired.worse += scenes.a[i].f() < scenes.b[i].f() ? 1 : 0;
    }
    return paired;
}

/// Sets the intervals. `scenes` has the scenes of each difference.
void add_ranges(std::vector<PairedScenes>& scenes,
                std::uint64_t seed,
                std::vector<PairedDifference>& differences) {
    std::map<std::string, std::size_t> index;
    for (const PairedScenes& paired : scenes)
        for (const std::string& name : paired.names)
            index.try_emplace(name);
    std::size_t count = 0;
    for (auto& [name, i] : index)
        i = count++;
    std::vector<statistics::PairedCounts> pairs;
    for (PairedScenes& paired : scenes) {
        std::vector<std::size_t> clusters;
        for (const std::string& name : paired.names)
            clusters.push_back(index.at(name));
        pairs.push_back({std::move(paired.a), std::move(paired.b), std::move(clusters)});
    }
    const auto ranges = statistics::paired_intervals(pairs, count, {.seed = seed});
    for (std::size_t i = 0; i < differences.size(); ++i) {
        differences[i].range = ranges[i].own;
        differences[i].range_of_all = ranges[i].of_all;
    }
}

std::optional<statistics::Interval> opposite(const std::optional<statistics::Interval>& range) {
    if (!range) return std::nullopt;
    return statistics::Interval{-range->high, -range->low};
}

/// The same of b less a.
PairedDifference turned_round(const PairedDifference& paired) {
    return {paired.b,
            paired.a,
            -paired.difference,
            opposite(paired.range),
            opposite(paired.range_of_all),
            paired.scenes,
            paired.worse,
            paired.better};
}

/// Methods with a score, without baselines.
std::vector<std::string> methods_best_first(std::vector<MethodSummary> summaries, Measure measure) {
    std::erase_if(summaries,
                  [&](const MethodSummary& s) { return s.is_baseline || !s.by(measure).all; });
    std::ranges::stable_sort(summaries, [&](const auto& a, const auto& b) {
        return *a.by(measure).all > *b.by(measure).all;
    });
    std::vector<std::string> names;
    for (const MethodSummary& summary : summaries)
        names.push_back(summary.method);
    return names;
}

}  // namespace

double PairedScenes::f_a() const {
    return pooled_f(a);
}

double PairedScenes::f_b() const {
    return pooled_f(b);
}

PairedScenes paired_scenes(std::span<const RowPair> pairs, Measure measure) {
    std::map<std::string, std::pair<Counts, Counts>> by_scene;
    for (const RowPair& pair : pairs) {
        if (!pair.a->is_scored() || !pair.b->is_scored()) continue;
        auto& [a, b] = by_scene[pair.a->scene];
        a += counts_of(*pair.a, measure);
        b += counts_of(*pair.b, measure);
    }
    PairedScenes scenes;
    for (const auto& [scene, sums] : by_scene) {
        scenes.a.push_back(sums.first);
        scenes.b.push_back(sums.second);
        scenes.names.push_back(scene);
    }
    return scenes;
}

std::vector<PairedDifference> all_paired_differences(const std::vector<harness::Row>& rows,
                                                     const std::vector<MethodSummary>& summaries,
                                                     Measure measure) {
    const std::vector<std::string> methods = methods_best_first(summaries, measure);
    std::vector<PairedDifference> once;
    std::vector<PairedScenes> scenes;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        for (std::size_t j = i + 1; j < methods.size(); ++j) {
            PairedScenes paired = pair_up(rows, methods[i], methods[j], measure);
            if (paired.is_empty()) continue;
            once.push_back(difference_of(methods[i], methods[j], paired));
            scenes.push_back(std::move(paired));
        }
    }
    if (once.empty()) return once;
    add_ranges(scenes, rows.front().seed, once);
    std::map<std::pair<std::string, std::string>, PairedDifference> found;
    for (const PairedDifference& paired : once) {
        found.emplace(std::pair(paired.a, paired.b), paired);
        found.emplace(std::pair(paired.b, paired.a), turned_round(paired));
    }
    std::vector<PairedDifference> differences;
    for (const std::string& a : methods) {
        for (const std::string& b : methods) {
            const auto paired = found.find({a, b});
            if (paired != found.end()) differences.push_back(paired->second);
        }
    }
    return differences;
}

const core::TableOf<PairedDifference>& differences_table() {
    static const auto kTable = [] {
        using D = PairedDifference;
        core::TableOf<D> table(
            "differences.csv",
            "A line per ordered pair of methods with a view in common, the best method first: by "
            "how much the pooled F within 2 px of one exceeds that of the other.");
        table.add({"method", "", "as in rows.csv"}, &D::a);
        table.add({"other", "", "the method it is compared with"}, &D::b);
        table.add({"difference", "-1..1", "F of `method` less that of `other`"}, &D::difference);
        const auto range = table.part(&D::range);
        range.add({"lo",
                   "-1..1",
                   "lower end of its nominal 95 % interval, scenes resampled for both together; "
                   "empty with "
                   "fewer than six scenes"},
                  &statistics::Interval::low);
        range.add({"hi", "-1..1", "upper end"}, &statistics::Interval::high);
        const auto range_of_all = table.part(&D::range_of_all);
        range_of_all.add({"lo_of_all",
                          "-1..1",
                          "lower end of the interval that is to hold together with those of all "
                          "other lines; above 0, `method` leads"},
                         &statistics::Interval::low);
        range_of_all.add({"hi_of_all", "-1..1", "upper end; below 0, `other` leads"},
                         &statistics::Interval::high);
        table.add({"scenes", "", "of which both have views"}, &D::scenes);
        table.add({"better", "", "of these, on which F of `method` is higher"}, &D::better);
        table.add({"worse", "", "and on which it is lower"}, &D::worse);
        return table;
    }();
    return kTable;
}

core::TableInfo soft_differences_table() {
    core::TableInfo table = differences_table().info();
    table.file = "soft_differences.csv";
    table.doc = "differences.csv of soft F; only with coverage.";
    return table;
}

std::string format_paired_difference(const PairedDifference& paired, bool has_zeros) {
    const auto& range = paired.range;
    if (!range) return format_signed(paired.difference, kDigits, has_zeros);
    const int digits = says_side(*range, kDigits) ? kDigits : kDigits + 1;
    return fmt::format("{} [{}, {}]",
                       format_signed(paired.difference, digits, has_zeros),
                       format_signed(range->low, digits, has_zeros),
                       format_signed(range->high, digits, has_zeros));
}

}  // namespace ink::summary
