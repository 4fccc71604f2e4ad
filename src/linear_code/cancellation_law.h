#pragma once

#include "method/method.h"

namespace ink::linear_code {

/// The largest dihedral deviation between two facets that a code and its threshold keep silent
/// whichever way the facets lie: their normals differ by 2 sin(deviation / 2), the code by |w|
/// sin(deviation / 2) at most (w the normal's weights, of (n + 1) / 2), and a pixel on a straight
/// line sees that once or twice. Depth is left out: across an edge where faces meet it bends, but
/// does not jump.
///
/// Radians, 0..pi; pi for a code that has no normal in it or a threshold that nothing reaches.
[[nodiscard]] double silent_deviation_rad(const method::LinearCode& code, int threshold);

// What one linear sum must miss of creases that bend by a deviation, if they lie in all directions
// alike: sin(silent / 2) / sin(deviation / 2), at most 1. In any direction the change of the normal
// has along w is uniform (Archimedes: a sphere's belts of equal height have equal area), so the
// share that stays below what the silent dihedral deviation makes at most is the ratio of the two.
// The page draws this curve (report/page/sections/cancellation.js).
// Source: the project's design, sections 6 and 9, there for silent = 10 degrees.

}  // namespace ink::linear_code
