#pragma once

#include "truth/trace_lines.h"

namespace ink::draw {

/// Leaves no two pieces of a drawing on each other, as ISO 128 wants it: what of a piece lies
/// within `within_px` of another that runs the same way is cut away, and of a visible and a hidden
/// piece the visible one stays; else the one of the class that is drawn on top (contour, boundary,
/// crease, intersection, seam), else the nearer one, else the first. Pieces that only cross stay
/// whole, a piece that is seen end-on, and so is a point, goes. Attributes and order stay.
///
/// Time grows as the pieces that share a cell, of 128 along the longer side of all of them.
void remove_covered(truth::TracedLines& lines, double within_px);

}  // namespace ink::draw
