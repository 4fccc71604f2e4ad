#pragma once

#include <vector>

#include "studies/axis.h"
#include "studies/skip_scenes.h"

namespace ink::studies {

/// What skips are worth: an axis called skips_off for every scene of studies/skip_scenes.h, whose
/// values are 1: every skip is allowed; 2: all but that which the scene was made for (the three
/// views have none); 3: none. An image that a skip changes is a fault.
///
/// Where nothing moves, `temporal_reuse` is off at every value (skips_of_repeated_drawings).
/// Nothing is scored. Scenes are made of `levels` (SkipScene).
[[nodiscard]] std::vector<Axis> skip_axes(int levels = kSkipSceneLevels);

}  // namespace ink::studies
