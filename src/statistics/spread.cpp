#include "statistics/spread.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>

namespace ink::statistics {

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

std::optional<double> mean(const std::vector<double>& values) {
    if (values.empty()) return std::nullopt;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace ink::statistics
