#include "statistics/bootstrap.h"

#include <numeric>
#include <utility>

#include "statistics/simultaneous.h"

namespace ink::statistics {
namespace {

std::optional<Interval> interval_of(const std::vector<score::CurveCount>& a,
                                    const std::vector<score::CurveCount>& b,
                                    const BootstrapOptions& options) {
    PairedCounts pair{a, b, std::vector<std::size_t>(a.size())};
    std::iota(pair.cluster.begin(), pair.cluster.end(), std::size_t{0});
    return paired_intervals({&pair, 1}, a.size(), options).front().own;
}

}  // namespace

int known_coverage_percent(int clusters) {
    return clusters < 11 ? 80 : clusters < 26 ? 85 : 90;
}

std::optional<Interval> f_interval(const std::vector<score::CurveCount>& clusters,
                                   const BootstrapOptions& options) {
    return interval_of(clusters, {}, options);
}

std::optional<Interval> paired_interval(const std::vector<score::CurveCount>& a,
                                        const std::vector<score::CurveCount>& b,
                                        const BootstrapOptions& options) {
    return interval_of(a, b, options);
}

}  // namespace ink::statistics
