#include "draw/outline_svg.h"

#include <fmt/format.h>

#include <numbers>
#include <utility>
#include <vector>

#include "core/escape.h"
#include "draw/palette.h"
#include "draw/svg_lines.h"
#include "truth/join_curves.h"

namespace ink::draw {
namespace {

constexpr double kDegPerRad = 180 / std::numbers::pi;

struct NamedKind {
    truth::ContourKind kind;
    const char* name;
};
constexpr NamedKind kKinds[] = {{truth::ContourKind::none, ""},
                                {truth::ContourKind::sky, "sky"},
                                {truth::ContourKind::other_object, "other_object"},
                                {truth::ContourKind::self, "self"}};

std::string points_of(const truth::Polyline& line, int decimals) {
    std::string points;
    for (const truth::CurvePoint& p : line.points) {
        if (!points.empty()) points += ' ';
        points += svg_number(p.x_px, decimals) + ',' + svg_number(p.y_px, decimals);
    }
    return points;
}

template <class Text>
std::string joined(const truth::Polyline& line, const truth::Truth& truth, Text text) {
    std::string all;
    for (const std::uint32_t i : line.curves)
        all += fmt::format("{}{}", all.empty() ? "" : " ", text(truth.curves[i]));
    return all;
}

std::string polyline(const truth::Polyline& line, const truth::Truth& truth) {
    const auto edge = [](const truth::Curve& c) {
        return c.edge == truth::kNoEdge ? std::string("-") : fmt::format("{}", c.edge);
    };
    const auto deviation = [](const truth::Curve& c) {
        return fmt::format("{:.4g}", c.deviation_rad * kDegPerRad);
    };
    const auto gap = [](const truth::Curve& c) { return fmt::format("{:.4g}", c.gap); };
    std::string text = fmt::format(R"(<polyline points="{}" data-edge="{}" data-dihedral-deg="{}")",
                                   points_of(line, 3),
                                   joined(line, truth, edge),
                                   joined(line, truth, deviation));
    if (line.empty_side != 0) {
        text += fmt::format(R"( data-gap="{}" data-empty="{}")",
                            joined(line, truth, gap),
                            line.empty_side > 0 ? "right" : "left");
    }
    text += "/>\n";
    return text;
}

std::string group(const std::vector<truth::Polyline>& lines,
                  const truth::Truth& truth,
                  truth::LineClass line_class,
                  const NamedKind& kind) {
    std::string body;
    for (const truth::Polyline& line : lines) {
        if (line.line_class == line_class && line.kind == kind.kind) body += polyline(line, truth);
    }
    if (body.empty()) return "";
    const std::string kind_text = kind.kind == truth::ContourKind::none
                                      ? std::string()
                                      : fmt::format(R"( data-kind="{}")", kind.name);
    return fmt::format(R"(<g data-class="{}"{} stroke="{}">
{}</g>
)",
                       truth::name(line_class),
                       kind_text,
                       colour_of(line_class).hex,
                       body);
}

}  // namespace

std::string outline_svg(const truth::Truth& truth,
                        const std::string& scene_name,
                        const scene::View& view) {
    const std::vector<truth::Polyline> lines = truth::join_curves(truth.curves);
    std::string body;
    for (const truth::LineClass line_class : kDrawnOrder) {
        for (const NamedKind& kind : kKinds)
            body += group(lines, truth, line_class, kind);
    }
    return fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}">
<title>{2}</title>
<rect width="{0}" height="{1}" fill="{3}"/>
<g fill="none" stroke-width="1" stroke-linecap="round" stroke-linejoin="round">
{4}</g>
</svg>
)",
        view.width_px,
        view.height_px,
        core::escape(fmt::format("{} {}: the visible lines", scene_name, view.camera.name)),
        kPaper.hex,
        body);
}

std::vector<ClassPath> class_paths(const truth::Truth& truth) {
    const std::vector<truth::Polyline> lines = truth::join_curves(truth.curves);
    std::vector<ClassPath> paths;
    for (const truth::LineClass line_class : kDrawnOrder) {
        std::string path;
        for (const truth::Polyline& line : lines) {
            if (line.line_class == line_class) path += 'M' + points_of(line, 2);
        }
        if (!path.empty()) paths.push_back({truth::name(line_class), std::move(path)});
    }
    return paths;
}

}  // namespace ink::draw
