#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace ink::score {

/// Many measurements as sums, so that they can be pooled.
struct Moments {
    std::int64_t n = 0;
    double sum = 0;
    double sum_of_squares = 0;

    void add(double value) {
        ++n;
        sum += value;
        sum_of_squares += value * value;
    }
    /// Nothing if nothing was measured, as the two below.
    [[nodiscard]] std::optional<double> mean() const {
        if (n == 0) return std::nullopt;
        return sum / static_cast<double>(n);
    }
    /// Standard deviation round the mean (of all, not of a sample).
    [[nodiscard]] std::optional<double> spread() const {
        if (n == 0) return std::nullopt;
        const double m = *mean();
        return std::sqrt(std::max(0.0, sum_of_squares / static_cast<double>(n) - m * m));
    }
    /// Root of the mean square: mean and spread in one.
    [[nodiscard]] std::optional<double> rms() const {
        if (n == 0) return std::nullopt;
        return std::sqrt(sum_of_squares / static_cast<double>(n));
    }
};

}  // namespace ink::score
