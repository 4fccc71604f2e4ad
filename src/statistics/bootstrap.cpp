#include "statistics/bootstrap.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>

namespace ink::statistics {
namespace {

using Drawn = std::vector<std::size_t>;

/// The middle 95 % of `statistic`, which is given the indices of the clusters that were drawn.
template <class Statistic>
std::optional<Interval> middle_of(std::size_t clusters,
                                  const BootstrapOptions& options,
                                  Statistic statistic) {
    if (clusters < 2) return std::nullopt;
    // The engine's sequence is fixed by the standard; its distributions are not, hence the modulo.
    std::mt19937_64 random(options.seed);
    std::vector<double> values;
    Drawn drawn(clusters);
    for (int i = 0; i < options.resamples; ++i) {
        for (std::size_t& index : drawn)
            index = static_cast<std::size_t>(random() % clusters);
        values.push_back(statistic(drawn));
    }
    return Interval{*quantile(values, 0.025), *quantile(values, 0.975)};
}

double f_of(const std::vector<score::CurveCount>& clusters, const Drawn& drawn) {
    score::CurveCount sum;
    for (const std::size_t index : drawn)
        sum += clusters[index];
    return sum.f();
}

/// A difference of pooled F and its standard error.
struct Estimate {
    double value = 0;
    double error = 0;
};

/// Where clusters that all differ by the same would leave rounding for an error.
constexpr double kNoError = 1e-12;
constexpr double kFar = 1e9;  ///< errors: further than any difference of F
/// With fewer an error is hardly known, and one such pair would widen the intervals of all.
constexpr std::size_t kFewestClusters = 6;

/// Counts as the sums below need them: F is hits over sum.
struct Side {
    double hits = 0;
    double sum = 0;
    [[nodiscard]] double f() const { return sum > 0 ? hits / sum : 1; }
};

Side& add(Side& side, const score::CurveCount& counts, double times) {
    side.hits += times * 2 * static_cast<double>(counts.k);
    side.sum += times * static_cast<double>(counts.n_pred + counts.n_truth);
    return side;
}

/// What one cluster adds to the pooled F less that F, to first order.
double influence(const score::CurveCount& counts, const Side& pooled) {
    if (!(pooled.sum > 0)) return 0;
    Side own;
    add(own, counts, 1);
    return (own.hits - pooled.f() * own.sum) / pooled.sum;
}

/// The difference of a pair when each cluster counts as often as it was drawn.
double difference_of(const PairedCounts& pair, const std::vector<int>& times) {
    Side a, b;
    for (std::size_t i = 0; i < pair.cluster.size(); ++i) {
        add(a, pair.a[i], times[pair.cluster[i]]);
        add(b, pair.b[i], times[pair.cluster[i]]);
    }
    return a.f() - b.f();
}

/// The difference over all clusters, with the error of a ratio of sums over clusters to first
/// order.
Estimate estimate_of(const PairedCounts& pair) {
    Side a, b;
    const std::size_t count = pair.cluster.size();
    for (std::size_t i = 0; i < count; ++i) {
        add(a, pair.a[i], 1);
        add(b, pair.b[i], 1);
    }
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double one = influence(pair.a[i], a) - influence(pair.b[i], b);
        squares += one * one;
    }
    const auto n = static_cast<double>(count);
    return {a.f() - b.f(), count > 1 ? std::sqrt(squares * n / (n - 1)) : 0};
}

/// The quantile of Student's distribution at which the normal one has `z`. Abramowitz and Stegun,
/// Handbook of Mathematical Functions, 1964, 26.7.5.
double students(double z, double freedom) {
    const double z2 = z * z;
    const double first = (z2 + 1) / 4;
    const double second = ((5 * z2 + 16) * z2 + 3) / 96;
    const double third = (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
    return z * (1 + (first + (second + third / freedom) / freedom) / freedom);
}

}  // namespace

std::optional<Interval> f_interval(const std::vector<score::CurveCount>& clusters,
                                   const BootstrapOptions& options) {
    return middle_of(
        clusters.size(), options, [&](const Drawn& drawn) { return f_of(clusters, drawn); });
}

std::optional<Interval> paired_interval(const std::vector<score::CurveCount>& a,
                                        const std::vector<score::CurveCount>& b,
                                        const BootstrapOptions& options) {
    assert(a.size() == b.size());
    return middle_of(
        a.size(), options, [&](const Drawn& drawn) { return f_of(a, drawn) - f_of(b, drawn); });
}

std::vector<std::optional<Interval>> simultaneous_intervals(std::span<const PairedCounts> pairs,
                                                            std::size_t cluster_count,
                                                            const BootstrapOptions& options) {
    std::vector<std::optional<Interval>> intervals(pairs.size());
    if (cluster_count < 2 || options.resamples < 2) return intervals;
    std::vector<Estimate> own;
    for (const PairedCounts& pair : pairs) {
        assert(pair.a.size() == pair.cluster.size());
        assert(pair.b.size() == pair.cluster.size());
        own.push_back(estimate_of(pair));
    }
    std::vector<double> largest(static_cast<std::size_t>(options.resamples), 0);
    std::mt19937_64 random(options.seed);
    std::vector<int> times(cluster_count);
    for (double& of_drawing : largest) {
        std::fill(times.begin(), times.end(), 0);
        for (std::size_t j = 0; j < cluster_count; ++j)
            ++times[random() % cluster_count];
        for (std::size_t p = 0; p < pairs.size(); ++p) {
            if (pairs[p].cluster.size() < kFewestClusters || !(own[p].error > kNoError)) continue;
            const double away = std::abs(difference_of(pairs[p], times) - own[p].value);
            of_drawing = std::max(of_drawing, away / own[p].error);
        }
    }
    const double reach = *quantile(largest, 0.95);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        const std::size_t count = pairs[p].cluster.size();
        if (count < 2) continue;
        const auto [value, error] = own[p];
        const double errors =
            count < kFewestClusters ? kFar : students(reach, static_cast<double>(count - 1));
        const double half = error > kNoError ? errors * error : 0;
        intervals[p] = Interval{std::max(-1.0, value - half), std::min(1.0, value + half)};
    }
    return intervals;
}

}  // namespace ink::statistics
