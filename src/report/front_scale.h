#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "experiment/summary/summary.h"
#include "report/svg.h"

namespace ink::report {

inline constexpr double kFrontWidth = 1000;
inline constexpr double kFrontHeight = 520;
/// Where values stand on the chart of error against time, in its units.
inline constexpr Box kFrontPlot{76, 22, 890, 432};
inline constexpr std::string_view kFaintText = "#5b6470";

/// From values to places on the plot, both logarithmic: time to the right, error upwards. An error
/// below the least, as 0, stands on the lower edge.
struct FrontScale {
    double log_min = 0;  ///< decimal logarithm of the time at the left end, ms
    double log_max = 1;
    double error_min = 0.001;  ///< at the bottom, above 0
    double error_max = 1;      ///< at the top

    [[nodiscard]] double x(double time_ms) const {
        return kFrontPlot.x +
               kFrontPlot.width * (std::log10(time_ms) - log_min) / (log_max - log_min);
    }
    [[nodiscard]] double y(double error) const {
        const double share =
            std::log(std::fmax(error, error_min) / error_min) / std::log(error_max / error_min);
        return kFrontPlot.y + kFrontPlot.height * (1 - share);
    }
};

/// Both axes with grid, ticks and titles.
void draw_front_axes(Svg& svg, const FrontScale& scale);

/// The rows that are no methods as dotted lines across: floor, ceiling, the truth itself, and what
/// the random baseline scores with as many pixels as the truth has. What lies above the plot is a
/// note at its top. Returns where their labels stand, each clear of the others.
std::vector<Box> draw_levels(Svg& svg,
                             const FrontScale& scale,
                             const std::vector<experiment::MethodSummary>& baselines);

}  // namespace ink::report
