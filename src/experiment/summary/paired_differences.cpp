#include "experiment/summary/paired_differences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/text_table.h"
#include "experiment/summary/summary.h"
#include "harness/tables/csv.h"
#include "statistics/bootstrap.h"

namespace ink::experiment {
namespace {

using Counts = score::CurveCount;

constexpr int kDigits = 3;

/// ".012" with the sign before it.
std::string format_signed(double value, int digits) {
    const std::string share = fmt::format("{:.{}f}", std::abs(value), digits);
    return fmt::format("{}{}", value < 0 ? '-' : '+', share[0] == '0' ? share.substr(1) : share);
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
        if (row.method == method && row.is_ok() && row.f_2px)
            found.emplace(harness::place_of(row), &row);
    }
    return found;
}

/// Counts of two methods, summed over the views of each scene that both have.
struct PairedClusters {
    std::vector<Counts> a;
    std::vector<Counts> b;
};

PairedClusters pair_up(const std::vector<harness::Row>& rows,
                       const std::string& a,
                       const std::string& b) {
    const auto of_b = rows_by_place(rows, b);
    std::map<std::string, std::pair<Counts, Counts>> by_scene;
    for (const auto& [where, row] : rows_by_place(rows, a)) {
        const auto other = of_b.find(where);
        if (other == of_b.end()) continue;
        auto& [sum_a, sum_b] = by_scene[row->scene];
        sum_a += counts_2px(*row);
        sum_b += counts_2px(*other->second);
    }
    PairedClusters clusters;
    for (const auto& [scene, sums] : by_scene) {
        clusters.a.push_back(sums.first);
        clusters.b.push_back(sums.second);
    }
    return clusters;
}

}  // namespace

std::optional<PairedDifference> paired_difference_of(const std::vector<harness::Row>& rows,
                                                     const std::string& a,
                                                     const std::string& b) {
    const PairedClusters clusters = pair_up(rows, a, b);
    if (clusters.a.empty()) return std::nullopt;
    Counts sum_a;
    Counts sum_b;
    for (std::size_t i = 0; i < clusters.a.size(); ++i) {
        sum_a += clusters.a[i];
        sum_b += clusters.b[i];
    }
    return PairedDifference{
        a,
        b,
        sum_a.f() - sum_b.f(),
        statistics::paired_interval(clusters.a, clusters.b, {.seed = rows.front().seed})};
}

std::vector<PairedDifference> all_paired_differences(const std::vector<harness::Row>& rows) {
    std::vector<MethodSummary> summaries = summarise(rows);
    std::erase_if(summaries, [](const MethodSummary& s) { return s.is_baseline || !s.f_2px; });
    std::stable_sort(summaries.begin(), summaries.end(), [](const auto& a, const auto& b) {
        return *a.f_2px > *b.f_2px;
    });
    std::vector<PairedDifference> differences;
    for (const MethodSummary& a : summaries) {
        for (const MethodSummary& b : summaries) {
            if (a.method == b.method) continue;
            if (auto paired = paired_difference_of(rows, a.method, b.method))
                differences.push_back(std::move(*paired));
        }
    }
    return differences;
}

const harness::TableInfo& differences_table() {
    static const harness::TableInfo kTable = {
        "differences.csv",
        "A line per ordered pair of methods with a view in common, the best method first: by how "
        "much the pooled F of one exceeds that of the other.",
        {{"method", "", "as in rows.csv"},
         {"other", "", "the method it is compared with"},
         {"difference", "-1..1", "F within 2 px of `method` less that of `other`"},
         {"lo",
          "-1..1",
          "lower end of its 95 % interval, scenes resampled for both together; empty with one "
          "scene"},
         {"hi", "-1..1", "upper end"}}};
    return kTable;
}

std::string differences_csv(const std::vector<PairedDifference>& differences) {
    std::string text = harness::heading(differences_table());
    for (const PairedDifference& each : differences) {
        text += fmt::format("{},{},{},{},{}\n",
                            harness::csv_field(each.a),
                            harness::csv_field(each.b),
                            each.difference,
                            each.range ? fmt::format("{}", each.range->low) : "",
                            each.range ? fmt::format("{}", each.range->high) : "");
    }
    return text;
}

std::string format_paired_difference(const PairedDifference& paired) {
    if (!paired.range) return format_signed(paired.difference, kDigits);
    const int digits = says_side(*paired.range, kDigits) ? kDigits : kDigits + 1;
    return fmt::format("{} [{}, {}]",
                       format_signed(paired.difference, digits),
                       format_signed(paired.range->low, digits),
                       format_signed(paired.range->high, digits));
}

}  // namespace ink::experiment
