#pragma once

#include <string>
#include <vector>

#include "lab/stress_axes.h"
#include "lab/stress_summary.h"
#include "lab/svg.h"

namespace ink::lab {

/// A mark below a chart.
struct StressTick {
    double value = 0;
    std::string text;
};

/// From values and errors to places on a plot: values as the axis says, errors upwards from 0.
class StressScale {
  public:
    StressScale(const StressAxis& axis, const std::vector<StressCurve>& curves, const Box& plot);

    [[nodiscard]] const Box& plot() const { return plot_; }
    [[nodiscard]] double x(double value) const;
    [[nodiscard]] double y(double error) const;
    /// At most about ten, of the values that there are.
    [[nodiscard]] std::vector<StressTick> ticks() const;
    [[nodiscard]] std::vector<double> error_ticks() const;

  private:
    const StressAxis& axis_;
    Box plot_;
    std::vector<double> values_;  ///< that there are, ascending
    double error_max_ = 0.1;
};

}  // namespace ink::lab
