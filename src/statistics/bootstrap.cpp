#include "statistics/bootstrap.h"

#include <cassert>
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

}  // namespace ink::statistics
