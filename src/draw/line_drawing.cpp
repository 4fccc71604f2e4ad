#include "draw/line_drawing.h"

#include <fmt/format.h>

#include <span>
#include <vector>

#include "core/escape.h"
#include "draw/svg_lines.h"

namespace ink::draw {
namespace {

constexpr int kDecimals = 4;

// Line widths of ISO 128: a wide line is twice a narrow one.
constexpr double kWide_mm = 0.35, kNarrow_mm = 0.18;
// Hidden lines are narrow and grey: black ones drown a house in its rafters and furniture.
constexpr const char* kHiddenStyle = R"(stroke="#666666" stroke-linecap="butt" )"
                                     R"(stroke-dasharray="1.5 0.75")";

double width_of(truth::LineClass c) {
    const bool is_outline = c == truth::LineClass::contour || c == truth::LineClass::boundary;
    return is_outline ? kWide_mm : kNarrow_mm;
}

std::string shape(const truth::Polyline& line, const std::string& id, double mm_per_px) {
    std::vector<std::string> points;
    for (const truth::CurvePoint& p : line.points) {
        points.push_back(svg_number(p.x_px * mm_per_px, kDecimals) + ',' +
                         svg_number(p.y_px * mm_per_px, kDecimals));
    }
    // One that closes is joined there as at its other corners.
    const bool is_closed = points.size() > 3 && points.front() == points.back();
    if (is_closed) points.pop_back();
    return fmt::format("<{} id=\"{}\" points=\"{}\"/>\n",
                       is_closed ? "polygon" : "polyline",
                       id,
                       fmt::join(points, " "));
}

std::string group(std::span<const truth::Polyline> lines,
                  truth::LineClass line_class,
                  const std::string& id,
                  double mm_per_px) {
    std::string text;
    int count = 0;
    for (const truth::Polyline& line : lines) {
        if (line.line_class == line_class)
            text += shape(line, fmt::format("{}-{}", id, ++count), mm_per_px);
    }
    return text;
}

}  // namespace

double usual_sheet_mm(int width_px) {
    constexpr double kMmPerInch = 25.4, kPxPerInch = 96;
    return width_px * kMmPerInch / kPxPerInch;
}

std::string line_drawing(const truth::DrawnLines& lines,
                         const std::string& scene_name,
                         const scene::View& view,
                         double width_mm) {
    const double mm_per_px = width_mm / view.width_px;
    std::string body;
    for (const truth::LineClass c : kDrawnOrder) {
        if (lines.hidden.empty()) break;
        const std::string id = fmt::format("hidden-{}", truth::name(c));
        body += fmt::format("<g id=\"{}\" stroke-width=\"{}\" {}>\n{}</g>\n",
                            id,
                            kNarrow_mm,
                            kHiddenStyle,
                            group(lines.hidden, c, id, mm_per_px));
    }
    for (const truth::LineClass c : kDrawnOrder) {
        const std::string id(truth::name(c));
        body += fmt::format("<g id=\"{}\" stroke-width=\"{}\">\n{}</g>\n",
                            id,
                            width_of(c),
                            group(lines.visible, c, id, mm_per_px));
    }
    return fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}mm" height="{1}mm">
<title>{2}</title>
<g fill="none" stroke="#000000" stroke-linecap="round" stroke-linejoin="round">
{3}</g>
</svg>
)",
        svg_number(width_mm, kDecimals),
        svg_number(view.height_px * mm_per_px, kDecimals),
        core::escape(fmt::format("{} {}", scene_name, view.camera.name)),
        body);
}

}  // namespace ink::draw
