#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/scaling.h"

namespace ink::experiment {

/// From one point of a method to the next on an axis.
struct ScalingStep {
    studies::ScalingAxis axis = studies::ScalingAxis::triangles;
    std::string method;
    double from = 0;      ///< x, in the axis' unit
    double to = 0;        ///< > from
    double exponent = 0;  ///< log of the ratio of times over log of that of x: 1 is linear
    /// What noise alone may add: both times off by their noise, against each other.
    double tolerance = 0;

    [[nodiscard]] bool is_worse_than_linear() const { return exponent > 1 + tolerance; }
};

/// The steps between neighbouring points of each method and axis, by axis, method (in order of
/// first appearance) and x. Two points of one x are no step.
[[nodiscard]] std::vector<ScalingStep> scaling_steps(
    const std::vector<studies::ScalingPoint>& points);

/// "No step is worse than linear." and the steepest, or how many are and the three steepest of
/// them, each with its exponent and the tolerance, as plain text; "" without steps.
[[nodiscard]] std::string scaling_sentence(const std::vector<ScalingStep>& steps);

/// A place on an axis as people read it: "985", "10.2 k", "8.29 M", "0.4 %".
[[nodiscard]] std::string format_scaling_x(studies::ScalingAxis axis, double x);

}  // namespace ink::experiment
