#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "scene/camera.h"
#include "truth/trace_lines.h"

namespace ink::draw {

/// The sheet that a drawing is on, and where the image lies on it.
struct Sheet {
    double width_mm = 0;
    double height_mm = 0;
    double mm_per_px = 0;
    double left_mm = 0;  ///< of the image's top left corner on the sheet
    double top_mm = 0;
};

/// A paper of ISO 216.
struct Paper {
    std::string_view name;
    double short_mm = 0;
    double long_mm = 0;
};
inline constexpr std::array<Paper, 5> kPapers{
    {{"A4", 210, 297}, {"A3", 297, 420}, {"A2", 420, 594}, {"A1", 594, 841}, {"A0", 841, 1189}}};
inline constexpr double kBorder_mm = 10;  ///< that a drawing leaves free all round on paper

/// The width in mm of an image that is shown at 96 px an inch, as browsers do.
[[nodiscard]] double usual_sheet_mm(int width_px);

/// A sheet that is the whole image.
[[nodiscard]] Sheet image_sheet(const scene::View& view, double width_mm);

/// The paper with the lines in its middle, lengthwise or across, whichever lets them be larger. A
/// parallel view has `mm_per_unit`, or the largest scale of ISO 5455 (1, 2 or 5 times a power of
/// ten) at which they fit; one in perspective fills the paper. None if they do not fit.
[[nodiscard]] std::optional<Sheet> paper_sheet(const Paper& paper,
                                               const scene::View& view,
                                               const truth::TracedLines& lines,
                                               std::optional<double> mm_per_unit);

/// Length on the sheet of a unit of the model, in a parallel view.
[[nodiscard]] double mm_per_unit(const Sheet& sheet, const scene::View& view);

/// "2:1", "1:5": a scale as drawings say it.
[[nodiscard]] std::string scale_text(double mm_per_unit);

/// The reverse, or a number alone; none for other text and for what is not above 0.
[[nodiscard]] std::optional<double> parse_scale(const std::string& text);

/// What is odd about the size of a sheet, or "": it is smaller than 20 mm, or larger than A0.
[[nodiscard]] std::string doubt_of_size(const Sheet& sheet);

/// How far apart two lines on the sheet must be to be two: .02 mm, a ninth of the narrowest pen, or
/// a quarter of a pixel where that is less.
[[nodiscard]] double same_line_px(const Sheet& sheet);

}  // namespace ink::draw
