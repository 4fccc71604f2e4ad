#include "harness/median_interval.h"

#include <algorithm>
#include <cmath>

namespace ink::harness {
namespace {

constexpr double kLeastCoverage = 0.75;

/// How many times at either end may be left out so that those between still have the median
/// between them in kLeastCoverage of the cases; -1 if all of them do not.
///
/// Of n times the median lies below all with probability 2^-n, and below all but the least k with
/// that of at most k heads in n throws.
int most_left_out(std::size_t n) {
    double outside = 0;
    double term = std::exp2(-static_cast<double>(n));
    int left_out = -1;
    for (std::size_t k = 0; 2 * k + 1 < n; ++k) {
        outside += 2 * term;
        if (1 - outside < kLeastCoverage) break;
        left_out = static_cast<int>(k);
        term *= static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
    return left_out;
}

}  // namespace

bool is_median_known(std::vector<std::int64_t> times_ns, double share) {
    const std::size_t n = times_ns.size();
    const int left_out = most_left_out(n);
    if (left_out < 0 || share <= 0) return false;
    std::sort(times_ns.begin(), times_ns.end());
    const auto low = times_ns[static_cast<std::size_t>(left_out)];
    const auto high = times_ns[n - 1 - static_cast<std::size_t>(left_out)];
    return static_cast<double>(high - low) <= share * static_cast<double>(times_ns[n / 2]);
}

}  // namespace ink::harness
