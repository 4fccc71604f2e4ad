#pragma once

#include <string>
#include <vector>

#include "studies/stress/stress_axes.h"
#include "studies/stress/stress_cases.h"

// What `stress_axes()` is put together from.

namespace ink::studies {

/// The cases of one value.
using StressMaker = std::vector<Case> (*)(const StressPoint&);

/// What an axis is called and what its values are.
struct StressHeading {
    std::string name;
    std::string title;
    std::string unit = "";
    AxisScale scale = AxisScale::log;
};

[[nodiscard]] Axis make_axis(StressHeading heading,
                             std::vector<double> values,
                             std::string sentence,
                             StressMaker make);

/// From `low` to `high`, both included.
[[nodiscard]] std::vector<double> evenly(double low, double high, double step);

// stress_axis_parameters.cpp: what methods and machine are set to, and what is wrong with triangles
void add_parameter_axes(std::vector<Axis>& axes);
void add_defect_axes(std::vector<Axis>& axes);

}  // namespace ink::studies
