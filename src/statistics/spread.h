#pragma once

#include <optional>
#include <vector>

namespace ink::statistics {

/// A range that holds a value with a stated confidence, or the middle half of some values.
struct Interval {
    double low = 0;
    double high = 0;
};

/// The q-quantile (0..1) of `values`, linear between the two nearest; nothing if there are none.
[[nodiscard]] std::optional<double> quantile(std::vector<double> values, double q);

/// The arithmetic mean of `values`; nothing if there are none.
[[nodiscard]] std::optional<double> mean(const std::vector<double>& values);

}  // namespace ink::statistics
