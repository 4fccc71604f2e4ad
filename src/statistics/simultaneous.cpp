#include "statistics/simultaneous.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>

namespace ink::statistics {
namespace {

/// A difference of pooled F and its standard error.
struct Estimate {
    double value = 0;
    double error = 0;  ///< 0 where one cluster alone was drawn, too
};

/// Where clusters that all differ by the same would leave rounding for an error.
constexpr double kNoError = 1e-12;
constexpr double kFar = 1e9;  ///< errors: further than any difference of F
/// Drawings of fewer often hold one cluster alone, which has no error. One such pair would widen
/// the intervals of all.
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

/// The difference of a pair when each cluster counts as often as it was drawn. The error is that of
/// a ratio of sums over clusters, to first order.
Estimate estimate_of(const PairedCounts& pair, const std::vector<int>& times) {
    Side a, b;
    double drawn = 0;
    for (std::size_t i = 0; i < pair.cluster.size(); ++i) {
        const double n = times[pair.cluster[i]];
        if (n == 0) continue;
        add(a, pair.a[i], n);
        add(b, pair.b[i], n);
        drawn += n;
    }
    double squares = 0;
    for (std::size_t i = 0; i < pair.cluster.size(); ++i) {
        const double n = times[pair.cluster[i]];
        if (n == 0) continue;
        const double one = influence(pair.a[i], a) - influence(pair.b[i], b);
        squares += n * one * one;
    }
    const double error = drawn > 1 ? std::sqrt(squares * drawn / (drawn - 1)) : 0;
    return {a.f() - b.f(), error};
}

/// How far a drawing lies from the pair's own difference, in units of the drawing's own error.
double distance(const Estimate& drawn, const Estimate& own) {
    const double away = std::abs(drawn.value - own.value);
    if (away <= kNoError) return 0;
    return drawn.error > kNoError ? away / drawn.error : kFar;
}

}  // namespace

std::vector<std::optional<Interval>> simultaneous_intervals(std::span<const PairedCounts> pairs,
                                                            std::size_t cluster_count,
                                                            const BootstrapOptions& options) {
    std::vector<std::optional<Interval>> intervals(pairs.size());
    if (cluster_count < 2 || options.resamples < 2) return intervals;
    const std::vector<int> once(cluster_count, 1);
    std::vector<Estimate> own;
    for (const PairedCounts& pair : pairs) {
        assert(pair.a.size() == pair.cluster.size());
        assert(pair.b.size() == pair.cluster.size());
        own.push_back(estimate_of(pair, once));
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
            of_drawing = std::max(of_drawing, distance(estimate_of(pairs[p], times), own[p]));
        }
    }
    const double reach = *quantile(largest, 0.95);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        if (pairs[p].cluster.size() < 2) continue;
        const auto [value, error] = own[p];
        const bool is_few = pairs[p].cluster.size() < kFewestClusters;
        const double half = !(error > kNoError) ? 0 : is_few ? kFar : reach * error;
        intervals[p] = Interval{std::max(-1.0, value - half), std::min(1.0, value + half)};
    }
    return intervals;
}

}  // namespace ink::statistics
