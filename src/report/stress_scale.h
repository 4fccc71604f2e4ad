#pragma once

#include <string>
#include <vector>

#include "experiment/summary/stress_summary.h"
#include "report/svg.h"
#include "studies/stress/stress_axes.h"

namespace ink::report {

/// A mark below a chart.
struct StressTick {
    double value = 0;
    std::string text;
};

/// From values and errors to places on a plot: values as the axis says, errors upwards from 0.
class StressScale {
  public:
    StressScale(const studies::StressAxis& axis,
                const std::vector<experiment::StressCurve>& curves,
                const Box& plot);

    [[nodiscard]] const Box& plot() const { return plot_; }
    [[nodiscard]] double x(double value) const;
    [[nodiscard]] double y(double error) const;
    /// At most about ten, of the values that there are.
    [[nodiscard]] std::vector<StressTick> ticks() const;
    [[nodiscard]] std::vector<double> error_ticks() const;

  private:
    const studies::StressAxis& axis_;
    Box plot_;
    std::vector<double> values_;  ///< that there are, ascending
    double error_max_ = 0.1;
};

}  // namespace ink::report
