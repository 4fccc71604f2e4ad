#include "lab/summary.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <tuple>

namespace ink::lab {
namespace {

constexpr int kResamples = 2000;
constexpr std::uint64_t kBootstrapSeed = 1;

/// Counts that add up over views, where F does not.
struct Counts {
    std::int64_t k = 0;
    std::int64_t n_pred = 0;
    std::int64_t n_truth = 0;

    void add(const Counts& other) {
        k += other.k;
        n_pred += other.n_pred;
        n_truth += other.n_truth;
    }
    [[nodiscard]] double f() const {
        const auto pixels = static_cast<double>(n_pred + n_truth);
        return pixels == 0 ? 1.0 : 2.0 * static_cast<double>(k) / pixels;
    }
};

Counts counts_2px(const Row& row) {
    return {row.k_2px, row.n_pred, row.n_truth};
}
Counts counts_1px(const Row& row) {
    return {row.k_1px, row.n_pred_1px, row.n_truth};
}

std::optional<double> share(std::int64_t part, std::int64_t whole) {
    if (whole == 0) return std::nullopt;
    return static_cast<double>(part) / static_cast<double>(whole);
}

using Rows = std::vector<const Row*>;

template <class CountsOf>
std::optional<double> pooled(const Rows& rows, CountsOf counts_of) {
    if (rows.empty()) return std::nullopt;
    Counts sum;
    for (const Row* row : rows)
        sum.add(counts_of(*row));
    return sum.f();
}

Rows of_split(const Rows& rows, std::string_view split) {
    Rows kept;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(kept), [&](const Row* row) {
        return row->split == split;
    });
    return kept;
}

/// The values that rows have, the empty ones left out.
template <class ValueOf>
std::vector<double> values_of(const Rows& rows, ValueOf value_of) {
    std::vector<double> values;
    for (const Row* row : rows) {
        if (const auto value = value_of(*row)) values.push_back(static_cast<double>(*value));
    }
    return values;
}

std::optional<double> mean(const std::vector<double>& values) {
    if (values.empty()) return std::nullopt;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The middle 95 % of `statistic` over resamplings of `count` things; it is given their indices.
/// Efron and Tibshirani, An Introduction to the Bootstrap, 1993, section 13.3 (percentiles).
template <class Statistic>
std::optional<Interval> bootstrap(std::size_t count, Statistic statistic) {
    if (count < 2) return std::nullopt;
    // The engine's sequence is fixed by the standard; its distributions are not, hence the modulo.
    std::mt19937_64 random(kBootstrapSeed);
    std::vector<double> values;
    std::vector<std::size_t> drawn(count);
    for (int i = 0; i < kResamples; ++i) {
        for (std::size_t& index : drawn)
            index = static_cast<std::size_t>(random() % count);
        values.push_back(statistic(drawn));
    }
    return Interval{*quantile(values, 0.025), *quantile(values, 0.975)};
}

double f_of(const Rows& rows, const std::vector<std::size_t>& drawn) {
    Counts sum;
    for (const std::size_t index : drawn)
        sum.add(counts_2px(*rows[index]));
    return sum.f();
}

std::optional<Interval> f_range(const Rows& rows) {
    return bootstrap(rows.size(), [&](const auto& drawn) { return f_of(rows, drawn); });
}

/// Recalls weighed by the truth pixels they are shares of. Counts of a class come back from its
/// recall exactly: they are far below 2^53.
std::map<std::string, double> pooled_recalls(const Rows& rows) {
    std::map<std::string, std::pair<double, double>> found_of;
    for (const Row* row : rows) {
        for (const auto& [name, recall] : row->recall_by_class) {
            const auto truth_px = row->truth_px_by_class.find(name);
            if (truth_px == row->truth_px_by_class.end() || truth_px->second == 0) continue;
            const auto n = static_cast<double>(truth_px->second);
            found_of[name].first += std::round(recall * n);
            found_of[name].second += n;
        }
    }
    std::map<std::string, double> recalls;
    for (const auto& [name, found] : found_of)
        recalls[name] = found.first / found.second;
    return recalls;
}

void summarise_scores(const Rows& rows, MethodSummary& summary) {
    const auto f_2px = values_of(rows, [](const Row& row) { return row.f_2px; });
    Counts sum;
    for (const Row* row : rows)
        sum.add(counts_2px(*row));
    summary.f_2px = pooled(rows, counts_2px);
    summary.f_2px_range = f_range(rows);
    summary.f_train = pooled(of_split(rows, "train"), counts_2px);
    summary.f_heldout = pooled(of_split(rows, "heldout"), counts_2px);
    summary.f_mean = mean(f_2px);
    summary.f_median = quantile(f_2px, 0.5);
    summary.f_1px = pooled(rows, counts_1px);
    summary.precision = share(sum.k, sum.n_pred);
    summary.recall = share(sum.k, sum.n_truth);
    summary.recall_by_class = pooled_recalls(rows);
    summary.mean_width_px = mean(values_of(rows, [](const Row& row) { return row.mean_width_px; }));
}

void summarise_costs(const Rows& rows, MethodSummary& summary) {
    std::vector<double> draw_ms = values_of(rows, [](const Row& row) { return row.draw_ns; });
    for (double& value : draw_ms)
        value *= 1e-6;
    summary.draw_ms = quantile(draw_ms, 0.5);
    if (draw_ms.size() > 1) {
        summary.draw_ms_quartiles = Interval{*quantile(draw_ms, 0.25), *quantile(draw_ms, 0.75)};
    }
    for (const Row* row : rows) {
        if (!row->bytes_per_px) continue;
        summary.bytes_per_px = std::max(summary.bytes_per_px.value_or(0), *row->bytes_per_px);
    }
}

/// Rows that did not fail, of one method.
Rows good_rows(const std::vector<Row>& rows, const std::string& method) {
    Rows good;
    for (const Row& row : rows) {
        if (row.method == method && row.is_ok() && row.f_2px) good.push_back(&row);
    }
    return good;
}

auto place(const Row& row) {
    return std::tie(row.scene, row.view, row.width, row.height);
}

}  // namespace

bool is_bracket(std::string_view method) {
    return method == "none" || method == "sampled" || method == "oracle";
}

std::optional<double> quantile(std::vector<double> values, double q) {
    assert(q >= 0 && q <= 1);
    if (values.empty()) return std::nullopt;
    std::sort(values.begin(), values.end());
    const double position = q * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    const double t = position - static_cast<double>(below);
    return values[below] + t * (values[above] - values[below]);
}

std::optional<double> pooled_f(const std::vector<const Row*>& rows) {
    Rows good;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(good), [](const Row* row) {
        return row->is_ok() && row->f_2px;
    });
    return pooled(good, counts_2px);
}

std::optional<Interval> f_lead(const std::vector<Row>& rows,
                               const std::string& a,
                               const std::string& b) {
    Rows of_a;
    Rows of_b;
    const Rows candidates = good_rows(rows, b);
    for (const Row* row : good_rows(rows, a)) {
        const auto same = std::find_if(candidates.begin(), candidates.end(), [&](const Row* other) {
            return place(*other) == place(*row);
        });
        if (same == candidates.end()) continue;
        of_a.push_back(row);
        of_b.push_back(*same);
    }
    return bootstrap(of_a.size(),
                     [&](const auto& drawn) { return f_of(of_a, drawn) - f_of(of_b, drawn); });
}

std::vector<std::size_t> pareto_front(const std::vector<CostPoint>& points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(points[a].time, points[a].error) <
               std::tie(points[b].time, points[b].error);
    });
    std::vector<std::size_t> front;
    for (const std::size_t index : order) {
        if (front.empty() || points[index].error < points[front.back()].error) {
            front.push_back(index);
        }
    }
    return front;
}

Verdict find_verdict(const std::vector<MethodSummary>& summaries) {
    Verdict verdict;
    for (const MethodSummary& s : summaries) {
        if (s.is_bracket || !s.f_2px) continue;
        if (verdict.best == nullptr || *s.f_2px > *verdict.best->f_2px) {
            verdict.runner_up = verdict.best;
            verdict.best = &s;
        } else if (verdict.runner_up == nullptr || *s.f_2px > *verdict.runner_up->f_2px) {
            verdict.runner_up = &s;
        }
        const bool is_cheaper =
            verdict.cheapest == nullptr || s.draw_ms < verdict.cheapest->draw_ms;
        if (s.draw_ms && is_cheaper) verdict.cheapest = &s;
    }
    return verdict;
}

std::vector<MethodSummary> summarise(const std::vector<Row>& rows) {
    std::vector<MethodSummary> summaries;
    for (const Row& row : rows) {
        const auto known = std::find_if(summaries.begin(), summaries.end(), [&](const auto& s) {
            return s.method == row.method;
        });
        if (known != summaries.end()) continue;
        MethodSummary summary;
        summary.method = row.method;
        summary.is_bracket = is_bracket(row.method);
        summaries.push_back(summary);
    }
    for (MethodSummary& summary : summaries) {
        const Rows good = good_rows(rows, summary.method);
        const auto all = std::count_if(
            rows.begin(), rows.end(), [&](const Row& row) { return row.method == summary.method; });
        summary.views = static_cast<int>(good.size());
        summary.failed = static_cast<int>(all) - summary.views;
        summarise_scores(good, summary);
        summarise_costs(good, summary);
    }
    std::stable_partition(
        summaries.begin(), summaries.end(), [](const MethodSummary& s) { return !s.is_bracket; });
    return summaries;
}

}  // namespace ink::lab
