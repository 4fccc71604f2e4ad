#pragma once

#include <string>

#include "draw/drawn_lines.h"
#include "draw/sheet.h"

namespace ink::draw {

/// The lines of an SVG drawing as an ASCII DXF file of release 12, in mm with y up from the sheet's
/// lower left corner: the same points, to 1/10000 mm, in the same order.
///
/// A layer per class is called by its name in capitals; hidden lines are in layers HIDDEN-CREASE
/// and so on, whose line type HIDDEN is dashed. Lines of two points are LINE, longer ones POLYLINE.
/// Release 12 has no variable for the unit: a comment says mm.
[[nodiscard]] std::string dxf_drawing(const DrawnLines& lines,
                                      const std::string& scene_name,
                                      const scene::View& view,
                                      const Sheet& sheet);

}  // namespace ink::draw
