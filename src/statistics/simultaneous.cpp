#include "statistics/simultaneous.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"

namespace ink::statistics {
namespace {

/// A difference of pooled F and its standard error.
struct Estimate {
    double value = 0;
    double error = 0;
};

/// Where clusters that all differ by the same would leave rounding for an error.
constexpr double kNoError = 1e-12;
/// Of the measured error, the least that a drawing's counts for: in a pair's own interval, and in
/// those of all. Chosen by simulation for coverage and width (experiments/notes/intervals.md).
constexpr double kLeastOwn = 0.25;
constexpr double kLeastOfAll = 0.5;

/// One method's counts by cluster, as the sums below need them: F is hits over pixels.
struct Side {
    std::vector<double> hits;
    std::vector<double> pixels;

    explicit Side(const std::vector<score::CurveCount>& clusters) {
        for (const score::CurveCount& counts : clusters) {
            hits.push_back(2 * static_cast<double>(counts.k));
            pixels.push_back(static_cast<double>(counts.n_pred + counts.n_truth));
        }
    }
};

/// F of a side where cluster i counts `times[i]`, and one over its pixels; 0 for what is not there.
struct Pooled {
    double f = 0;
    double per_pixel = 0;
};

Pooled pooled(const Side& side, const std::vector<double>& times) {
    if (side.hits.empty()) return {};
    double hits = 0;
    double pixels = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        hits += times[i] * side.hits[i];
        pixels += times[i] * side.pixels[i];
    }
    return pixels > 0 ? Pooled{hits / pixels, 1 / pixels} : Pooled{1, 0};
}

/// What cluster i adds to the pooled F less that F, to first order.
double influence(const Side& side, const Pooled& pooled, std::size_t i) {
    if (side.hits.empty()) return 0;
    return (side.hits[i] - pooled.f * side.pixels[i]) * pooled.per_pixel;
}

/// The error is that of a ratio of sums over clusters, to first order.
Estimate estimate_of(const Side& a, const Side& b, const std::vector<double>& times) {
    const Pooled of_a = pooled(a, times);
    const Pooled of_b = pooled(b, times);
    double squares = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double one = influence(a, of_a, i) - influence(b, of_b, i);
        squares += times[i] * one * one;
    }
    const auto n = static_cast<double>(times.size());
    return {of_a.f - of_b.f, std::sqrt(squares * n / (n - 1))};
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

/// A pair as it was measured, and how many errors away each drawing has it.
struct Distances {
    Estimate measured;
    std::vector<double> own;
};

/// Raises the largest distance of each drawing to that of this pair.
Distances distances_of(const PairedCounts& pair,
                       const std::vector<std::vector<double>>& drawings,
                       std::vector<double>& largest) {
    const Side a(pair.a);
    const Side b(pair.b);
    const std::size_t count = pair.cluster.size();
    Distances distances{estimate_of(a, b, std::vector<double>(count, 1)), {}};
    const auto [value, error] = distances.measured;
    if (!(error > kNoError)) return distances;
    std::vector<double> times(count);
    for (std::size_t d = 0; d < drawings.size(); ++d) {
        for (std::size_t i = 0; i < count; ++i)
            times[i] = drawings[d][pair.cluster[i]];
        const Estimate drawn = estimate_of(a, b, times);
        const double away = drawn.value - value;
        distances.own.push_back(away / std::max(drawn.error, kLeastOwn * error));
        largest[d] =
            std::max(largest[d], std::abs(away) / std::max(drawn.error, kLeastOfAll * error));
    }
    return distances;
}

/// Around a measured difference, of ends so many errors away, within what can be.
Interval interval_of(const Estimate& measured, double below, double above, bool is_difference) {
    return {std::max(is_difference ? -1.0 : 0.0, measured.value - below * measured.error),
            std::min(1.0, measured.value + above * measured.error)};
}

}  // namespace

std::vector<PairedIntervals> paired_intervals(std::span<const PairedCounts> pairs,
                                              std::size_t cluster_count,
                                              const BootstrapOptions& options) {
    std::vector<PairedIntervals> intervals(pairs.size());
    if (cluster_count < kFewestClusters || options.resamples < 2) return intervals;
    const std::vector<std::vector<double>> drawings = drawings_of(cluster_count, options);
    std::vector<Distances> distances(pairs.size());
    constexpr std::size_t kPairsAtOnce = 16;
    const auto parts = core::parallel_parts<std::vector<double>>(
        pairs.size(),
        kPairsAtOnce,
        core::hardware_threads(),
        [&](std::size_t begin, std::size_t end, std::vector<double>& largest) {
            largest.assign(drawings.size(), 0);
            for (std::size_t p = begin; p < end; ++p) {
                const PairedCounts& pair = pairs[p];
                assert(pair.a.size() == pair.cluster.size());
                assert(pair.b.empty() || pair.b.size() == pair.cluster.size());
                if (pair.cluster.size() >= kFewestClusters)
                    distances[p] = distances_of(pair, drawings, largest);
            }
        });
    std::vector<double> largest(drawings.size(), 0);
    for (const std::vector<double>& of_part : parts) {
        for (std::size_t d = 0; d < largest.size(); ++d)
            largest[d] = std::max(largest[d], of_part[d]);
    }
    const double reach = *quantile(largest, 0.95);
    core::parallel_for(pairs.size(), core::hardware_threads(), [&](std::size_t p) {
        const std::size_t count = pairs[p].cluster.size();
        if (count < kFewestClusters) return;
        const auto& [measured, own] = distances[p];
        const bool is_difference = !pairs[p].b.empty();
        const double half = own.empty() ? 0 : students(reach, static_cast<double>(count - 1));
        intervals[p] = {interval_of(measured,
                                    quantile(own, 0.975).value_or(0),
                                    -quantile(own, 0.025).value_or(0),
                                    is_difference),
                        interval_of(measured, half, half, is_difference)};
    });
    return intervals;
}

}  // namespace ink::statistics
