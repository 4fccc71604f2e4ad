#pragma once

#include <string>
#include <vector>

#include "draw/sheet.h"
#include "scene/camera.h"
#include "truth/join_curves.h"
#include "truth/model.h"
#include "truth/trace_lines.h"

namespace ink::draw {

/// The lines of a view as long runs of one class: what a drawing shows.
struct DrawnLines {
    std::vector<truth::Polyline> visible;
    std::vector<truth::Polyline> hidden;  ///< empty unless asked for
};

/// Traces the lines of a view alone. The same for every thread count; throws as
/// truth::trace_lines(). An empty image has no lines.
[[nodiscard]] truth::TracedLines trace_drawn_lines(const truth::Model& model,
                                                   const scene::View& view,
                                                   const truth::TruthOptions& options,
                                                   truth::Hidden hidden);

/// Joins pieces by class, whatever lies behind them: a run ends at a corner where more than two
/// pieces of its class meet, or where it becomes hidden. Nothing is known of kind and empty side.
[[nodiscard]] DrawnLines joined_by_class(truth::TracedLines lines);

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

/// Leaves no two pieces of a drawing on each other, as ISO 128 wants it: what of a piece lies
/// within `within_px` of another that runs the same way is cut away, and of a visible and a hidden
/// piece the visible one stays; else the one of the class that is drawn on top (contour, boundary,
/// crease, intersection, seam), else the nearer one, else the first. Pieces that only cross stay
/// whole, a piece that is seen end-on, and so is a point, goes. Attributes and order stay.
///
/// Time grows as the pieces that share a cell, of 128 along the longer side of all of them.
void remove_covered(truth::TracedLines& lines, double within_px);

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
