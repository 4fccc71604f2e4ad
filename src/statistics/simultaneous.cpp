#include "statistics/simultaneous.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>

namespace ink::statistics {
namespace {

score::CurveCount& add(score::CurveCount& sum, const score::CurveCount& counts, int times) {
    sum.k += times * counts.k;
    sum.n_pred += times * counts.n_pred;
    sum.n_truth += times * counts.n_truth;
    return sum;
}

/// The difference of a pair when each cluster counts as often as it was drawn.
double difference_of(const PairedCounts& pair, const std::vector<int>& times) {
    score::CurveCount a, b;
    for (std::size_t i = 0; i < pair.cluster.size(); ++i) {
        add(a, pair.a[i], times[pair.cluster[i]]);
        add(b, pair.b[i], times[pair.cluster[i]]);
    }
    return a.f() - b.f();
}

double standard_deviation(const std::vector<double>& values) {
    double sum = 0, squares = 0;
    for (const double value : values)
        sum += value;
    const double mean = sum / static_cast<double>(values.size());
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

}  // namespace

std::vector<std::optional<Interval>> simultaneous_intervals(std::span<const PairedCounts> pairs,
                                                            std::size_t cluster_count,
                                                            const BootstrapOptions& options) {
    std::vector<std::optional<Interval>> intervals(pairs.size());
    if (cluster_count < 2 || options.resamples < 2) return intervals;
    std::vector<std::vector<double>> drawn(pairs.size());
    std::mt19937_64 random(options.seed);
    for (int i = 0; i < options.resamples; ++i) {
        std::vector<int> times(cluster_count, 0);
        for (std::size_t j = 0; j < cluster_count; ++j)
            ++times[random() % cluster_count];
        for (std::size_t p = 0; p < pairs.size(); ++p)
            drawn[p].push_back(difference_of(pairs[p], times));
    }
    const std::vector<int> once(cluster_count, 1);
    std::vector<double> value(pairs.size()), error(pairs.size());
    std::vector<double> largest(static_cast<std::size_t>(options.resamples), 0);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        assert(pairs[p].a.size() == pairs[p].cluster.size());
        assert(pairs[p].b.size() == pairs[p].cluster.size());
        value[p] = difference_of(pairs[p], once);
        error[p] = standard_deviation(drawn[p]);
        if (!(error[p] > 0) || pairs[p].cluster.size() < 2) continue;
        for (std::size_t i = 0; i < largest.size(); ++i)
            largest[i] = std::max(largest[i], std::abs(drawn[p][i] - value[p]) / error[p]);
    }
    const double reach = *quantile(largest, 0.95);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        if (pairs[p].cluster.size() < 2) continue;
        intervals[p] = Interval{value[p] - reach * error[p], value[p] + reach * error[p]};
    }
    return intervals;
}

}  // namespace ink::statistics
