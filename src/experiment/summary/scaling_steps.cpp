#include "experiment/summary/scaling_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ink::experiment {
namespace {

std::vector<std::string> methods_of(const std::vector<studies::ScalingPoint>& points) {
    std::vector<std::string> methods;
    for (const studies::ScalingPoint& point : points) {
        if (std::find(methods.begin(), methods.end(), point.method) == methods.end())
            methods.push_back(point.method);
    }
    return methods;
}

/// The points of one line of a chart, by x.
std::vector<studies::ScalingPoint> line_of(const std::vector<studies::ScalingPoint>& points,
                                           studies::ScalingAxis axis,
                                           const std::string& method) {
    std::vector<studies::ScalingPoint> line;
    for (const studies::ScalingPoint& point : points) {
        if (point.axis == axis && point.method == method && point.is_timed()) line.push_back(point);
    }
    std::stable_sort(
        line.begin(),
        line.end(),
        [](const studies::ScalingPoint& a, const studies::ScalingPoint& b) { return a.x < b.x; });
    return line;
}

ScalingStep step_between(const studies::ScalingPoint& a, const studies::ScalingPoint& b) {
    const double growth = std::log(b.x / a.x);
    const double times = static_cast<double>(b.draw_ns_min) / static_cast<double>(a.draw_ns_min);
    const double noise = (1 + a.noise) * (1 + b.noise);
    return {a.axis, a.method, a.x, b.x, std::log(times) / growth, std::log(noise) / growth};
}

/// "mote4 from 10.2 k to 100 k triangles, exponent 1.31 (noise alone may make 1.09)".
std::string words(const ScalingStep& step) {
    const studies::ScalingAxisInfo& axis =
        studies::scaling_axes()[static_cast<std::size_t>(step.axis)];
    return fmt::format("{} from {} to {} {}, exponent {:.2f} (noise alone can give {:.2f})",
                       step.method,
                       format_scaling_x(step.axis, step.from),
                       format_scaling_x(step.axis, step.to),
                       axis.noun,
                       step.exponent,
                       1 + step.tolerance);
}

}  // namespace

std::vector<ScalingStep> scaling_steps(const std::vector<studies::ScalingPoint>& points) {
    std::vector<ScalingStep> steps;
    for (const studies::ScalingAxisInfo& axis : studies::scaling_axes()) {
        for (const std::string& method : methods_of(points)) {
            const std::vector<studies::ScalingPoint> line = line_of(points, axis.axis, method);
            for (std::size_t i = 1; i < line.size(); ++i) {
                if (line[i].x > line[i - 1].x) steps.push_back(step_between(line[i - 1], line[i]));
            }
        }
    }
    return steps;
}

std::string scaling_sentence(const std::vector<ScalingStep>& steps) {
    if (steps.empty()) return "";
    std::vector<ScalingStep> steepest = steps;
    std::stable_sort(
        steepest.begin(), steepest.end(), [](const ScalingStep& a, const ScalingStep& b) {
            return a.exponent - a.tolerance > b.exponent - b.tolerance;
        });
    const auto worse = std::count_if(steps.begin(), steps.end(), [](const ScalingStep& step) {
        return step.is_worse_than_linear();
    });
    if (worse == 0) {
        return fmt::format("No step is worse than linear. The steepest: {}.",
                           words(steepest.front()));
    }
    steepest.resize(static_cast<std::size_t>(std::min<std::ptrdiff_t>(worse, 3)));
    std::string named;
    for (const ScalingStep& step : steepest)
        named += (named.empty() ? "" : "; ") + words(step);
    return fmt::format(
        "Worse than linear in {} of {} steps. The steepest: {}.", worse, steps.size(), named);
}

std::string format_scaling_x(studies::ScalingAxis axis, double x) {
    if (axis == studies::ScalingAxis::covered) return fmt::format("{:.3g} %", 100 * x);
    // Three digits that count.
    if (x >= 999'500) return fmt::format("{:.3g} M", x / 1e6);
    if (x >= 9'995) return fmt::format("{:.3g} k", x / 1e3);
    return fmt::format("{:.0f}", x);
}

}  // namespace ink::experiment
