#include "draw/line_drawing.h"

#include <fmt/format.h>

#include <span>
#include <vector>

#include "core/escape.h"
#include "draw/svg_lines.h"
#include "truth/eye_scene.h"
#include "truth/eye_view.h"

namespace ink::draw {
namespace {

std::vector<truth::Polyline> joined(std::vector<truth::Curve> curves) {
    for (truth::Curve& curve : curves)
        curve.kind = truth::ContourKind::none;
    return truth::join_curves(curves);
}

// Line widths of ISO 128: a wide line is twice a narrow one.
constexpr double kWide_mm = 0.35, kNarrow_mm = 0.18;
// Hidden lines are narrow and grey: black ones drown a house in its rafters and furniture.
constexpr const char* kHiddenStyle = R"(stroke="#666666" stroke-linecap="butt" )"
                                     R"(stroke-dasharray="1.5 0.75")";

double width_of(truth::LineClass c) {
    const bool is_outline = c == truth::LineClass::contour || c == truth::LineClass::boundary;
    return is_outline ? kWide_mm : kNarrow_mm;
}

std::string shape(const truth::Polyline& line, const std::string& id, const Sheet& sheet) {
    std::vector<std::string> points;
    for (const truth::CurvePoint& p : line.points) {
        points.push_back(svg_number(sheet.left_mm + p.x_px * sheet.mm_per_px, kSheetDecimals) +
                         ',' + svg_number(sheet.top_mm + p.y_px * sheet.mm_per_px, kSheetDecimals));
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
                  const Sheet& sheet) {
    std::string text;
    int count = 0;
    for (const truth::Polyline& line : lines) {
        if (line.line_class == line_class)
            text += shape(line, fmt::format("{}-{}", id, ++count), sheet);
    }
    return text;
}

}  // namespace

truth::TracedLines trace_drawn_lines(const truth::Model& model,
                                     const scene::View& view,
                                     const truth::TruthOptions& options,
                                     truth::Hidden hidden) {
    if (view.width_px <= 0 || view.height_px <= 0) return {};
    const truth::EyeView eye(model, view, options.threads);
    const truth::EyeScene scene(model.topology, view.camera, options.threads);
    return truth::trace_lines(eye, scene, options, hidden);
}

DrawnLines joined_by_class(truth::TracedLines lines) {
    return {joined(std::move(lines.curves)), joined(std::move(lines.hidden))};
}

std::string line_drawing(const DrawnLines& lines,
                         const std::string& scene_name,
                         const scene::View& view,
                         const Sheet& sheet) {
    std::string body;
    for (const truth::LineClass c : kDrawnOrder) {
        if (lines.hidden.empty()) break;
        const std::string id = fmt::format("hidden-{}", truth::name(c));
        body += fmt::format("<g id=\"{}\" stroke-width=\"{}\" {}>\n{}</g>\n",
                            id,
                            kNarrow_mm,
                            kHiddenStyle,
                            group(lines.hidden, c, id, sheet));
    }
    for (const truth::LineClass c : kDrawnOrder) {
        const std::string id(truth::name(c));
        body += fmt::format("<g id=\"{}\" stroke-width=\"{}\">\n{}</g>\n",
                            id,
                            width_of(c),
                            group(lines.visible, c, id, sheet));
    }
    return fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}mm" height="{1}mm">
<title>{2}</title>
<g fill="none" stroke="#000000" stroke-linecap="round" stroke-linejoin="round">
{3}</g>
</svg>
)",
        svg_number(sheet.width_mm, kSheetDecimals),
        svg_number(sheet.height_mm, kSheetDecimals),
        core::escape(fmt::format("{} {}", scene_name, view.camera.name)),
        body);
}

}  // namespace ink::draw
