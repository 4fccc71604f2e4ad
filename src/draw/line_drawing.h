#pragma once

#include <string>

#include "draw/drawn_lines.h"
#include "draw/sheet.h"
#include "scene/camera.h"

namespace ink::draw {

inline constexpr int kSheetDecimals = 4;  ///< of a mm

/// The lines of `view` as an SVG file for print, in mm.
///
/// A group per class, called by its name, holds the lines, called by class and count ("crease-3").
/// If there are hidden lines, all of them are dashed and grey in groups "hidden-crease" below.
/// Contours and boundaries are 0.35 mm wide, other lines 0.18 mm. Points are rounded to 1/10000 mm.
[[nodiscard]] std::string line_drawing(const DrawnLines& lines,
                                       const std::string& scene_name,
                                       const scene::View& view,
                                       const Sheet& sheet);

}  // namespace ink::draw
