#pragma once

#include <string>
#include <vector>

#include "studies/axis.h"

namespace ink::studies {

/// All axes of difficulty in the order of the design; names are unique, and each has eight values
/// at least.
[[nodiscard]] const std::vector<Axis>& stress_axes();

/// The axis called `name`. Throws core::Error that lists the known ones.
[[nodiscard]] const Axis& find_stress_axis(const std::string& name);

}  // namespace ink::studies
