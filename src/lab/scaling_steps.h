#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/scaling.h"

namespace ink::lab {

/// How sure a least time is: two runs of one frame differ by this share at most. What an exponent
/// may exceed 1 by without meaning anything follows from it.
inline constexpr double kTimeNoise = 0.1;

/// From one point of a method to the next on an axis.
struct ScalingStep {
    ScalingAxis axis = ScalingAxis::triangles;
    std::string method;
    double from = 0;      ///< x, in the axis' unit
    double to = 0;        ///< > from
    double exponent = 0;  ///< log of the ratio of times over log of that of x: 1 is linear
    /// What noise alone may add: both times off by kTimeNoise, against each other.
    double tolerance = 0;

    [[nodiscard]] bool is_worse_than_linear() const { return exponent > 1 + tolerance; }
};

/// The steps between neighbouring points of each method and axis, by axis, method (in order of
/// first appearance) and x. Two points of one x are no step.
[[nodiscard]] std::vector<ScalingStep> scaling_steps(const std::vector<ScalingPoint>& points);

/// "No step is worse than linear: ..." or which are, in one or two sentences of plain text, with
/// the largest exponent and the tolerance; "" without steps.
[[nodiscard]] std::string scaling_sentence(const std::vector<ScalingStep>& steps);

/// A place on an axis as people read it: "985", "10.2 k", "8.29 M", "0.4 %".
[[nodiscard]] std::string format_scaling_x(ScalingAxis axis, double x);

}  // namespace ink::lab
