#pragma once

#include <glm/vec3.hpp>

namespace ink::raster {

/// What of the segment from a to b, (x, y, w) in clip space, lies inside the near plane (w >= near)
/// and the guard band, in place. False: nothing does. Both must be finite (outcode without
/// kNotANumber). A cut is the same, bit for bit, from whichever end the segment is given. Liang and
/// Barsky 1984, "A new concept and method for line clipping".
[[nodiscard]] bool clip_line(glm::dvec3& a, glm::dvec3& b, double near);

}  // namespace ink::raster
