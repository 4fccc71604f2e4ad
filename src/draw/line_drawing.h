#pragma once

#include <string>

#include "scene/camera.h"
#include "truth/drawn_lines.h"

namespace ink::draw {

/// The width in mm of an image that is shown at 96 px an inch, as browsers do.
[[nodiscard]] double usual_sheet_mm(int width_px);

/// The lines of `view` as an SVG file for print, in mm on a sheet `width_mm` wide.
///
/// A group per class, called by its name, holds the lines, called by class and count ("crease-3").
/// If there are hidden lines, all of them are dashed and grey in groups "hidden-crease" below.
/// Contours and boundaries are 0.35 mm wide, other lines 0.18 mm. Points are rounded to 1/10000 mm.
[[nodiscard]] std::string line_drawing(const truth::DrawnLines& lines,
                                       const std::string& scene_name,
                                       const scene::View& view,
                                       double width_mm);

}  // namespace ink::draw
