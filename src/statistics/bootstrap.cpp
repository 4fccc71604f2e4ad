#include "statistics/bootstrap.h"

#include <numeric>
#include <random>
#include <utility>

#include "statistics/simultaneous.h"

namespace ink::statistics {
std::vector<std::vector<double>> drawings_of(std::size_t clusters,
                                             const BootstrapOptions& options) {
    // The engine's sequence is fixed by the standard; its distributions are not, hence the modulo.
    std::mt19937_64 random(options.seed);
    std::vector<std::vector<double>> drawings(static_cast<std::size_t>(options.resamples),
                                              std::vector<double>(clusters, 0));
    for (std::vector<double>& times : drawings) {
        for (std::size_t i = 0; i < clusters; ++i)
            times[random() % clusters] += 1;
    }
    return drawings;
}

int known_coverage_percent(int clusters) {
    return clusters < 11 ? 80 : clusters < 26 ? 85 : 90;
}

std::optional<Interval> f_interval(const std::vector<score::CurveCount>& clusters,
                                   const BootstrapOptions& options) {
    return paired_interval(clusters, {}, options);
}

std::optional<Interval> paired_interval(const std::vector<score::CurveCount>& a,
                                        const std::vector<score::CurveCount>& b,
                                        const BootstrapOptions& options) {
    PairedCounts pair{a, b, std::vector<std::size_t>(a.size())};
    std::iota(pair.cluster.begin(), pair.cluster.end(), std::size_t{0});
    return paired_intervals({&pair, 1}, a.size(), options).front().own;
}

}  // namespace ink::statistics
