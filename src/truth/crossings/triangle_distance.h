#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace ink::truth {

/// How far a point is from the nearest point of a closed triangle, world units.
///
/// By the region in which its projection falls (Ericson 2005, "Real-Time Collision Detection",
/// section 5.1.5), so that it needs no normal and holds for needles too.
[[nodiscard]] double distance_to_triangle(const glm::dvec3& p,
                                          const std::array<glm::dvec3, 3>& corners);

}  // namespace ink::truth
