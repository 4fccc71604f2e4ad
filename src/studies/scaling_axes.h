#pragma once

#include <vector>

#include "studies/axis.h"

namespace ink::studies {

/// What a frame's time grows with, on spheres made by code: their triangles (10^2 to 10^6), the
/// pixels of the image (0.3 to 33 million), the share of it that is covered (a thousandth to all).
/// Everything else stays as it is. Nothing is scored.
[[nodiscard]] std::vector<Axis> scaling_axes();

}  // namespace ink::studies
