#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "buffers/codes/smooth_mesh.h"

namespace ink::buffers {

/// A unit normal per face; those of one patch on the same side of it, whichever way its faces are
/// turned, as far as it has two sides. 0 where the area is too small for a double.
[[nodiscard]] std::vector<glm::dvec3> patch_normals(const SmoothMesh& mesh);

/// How far the normals of a fan lie from their mean, as the largest distance between unit vectors,
/// per fan.
[[nodiscard]] std::vector<double> fan_spreads(const SmoothMesh& mesh,
                                              const std::vector<glm::dvec3>& normals);

}  // namespace ink::buffers
