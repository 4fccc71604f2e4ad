#include "report/stress_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/escape.h"
#include "draw/palette.h"
#include "experiment/summary/summary.h"
#include "report/method_looks.h"
#include "report/stress_scale.h"

namespace ink::report {
namespace {

constexpr double kWidth = 1180;
constexpr double kPanelWidth = 590;
constexpr double kPanelHeight = 320;
constexpr double kPlotWidth = 372;
constexpr double kPlotHeight = 226;
constexpr double kLeft = 58;
constexpr double kTop = 34;
constexpr double kNamedFoot = 50;  // more room below for names of values
constexpr double kLabelStep = 15;
constexpr std::string_view kFaint = "#5b6470";
constexpr std::string_view kGrid = R"(stroke="#e6e8eb" stroke-width="1")";

/// A method's line in its panel.
struct Line {
    const experiment::StressCurve* curve;
    std::string_view colour;
    bool is_tuned;
};

std::vector<Line> lines_of(method::Family family,
                           const std::vector<experiment::StressCurve>& curves) {
    std::vector<Line> lines;
    std::vector<std::string_view> bases;
    for (const experiment::StressCurve& curve : curves) {
        if (harness::is_baseline(curve.method) || look_of(curve.method).family != family) continue;
        if (curve.best() == nullptr) continue;
        const std::string_view base = base_of(curve.method);
        auto at = std::find(bases.begin(), bases.end(), base);
        if (at == bases.end()) at = bases.insert(bases.end(), base);
        const auto i = static_cast<std::size_t>(at - bases.begin());
        lines.push_back({&curve,
                         draw::kMethodColours[i % draw::kMethodColours.size()].hex,
                         base.size() != curve.method.size()});
    }
    return lines;
}

void draw_axes(Svg& svg,
               const StressScale& scale,
               const studies::StressAxis& axis,
               std::string_view title) {
    const Box& plot = scale.plot();
    const double bottom = plot.y + plot.height;
    svg.text(plot.x, plot.y - 12, title, {.fill = "#20242a", .size = 14, .is_bold = true});
    for (const double error : scale.error_ticks()) {
        const double y = scale.y(error);
        svg.line(plot.x, y, plot.x + plot.width, y, kGrid);
        svg.text(plot.x - 7, y + 4, fmt::format("{:.4g}", error), {"end", kFaint, 12});
    }
    for (const StressTick& tick : scale.ticks()) {
        const double x = scale.x(tick.value);
        svg.line(x, plot.y, x, bottom, kGrid);
        if (axis.scale != studies::AxisScale::named) {
            svg.text(x, bottom + 17, tick.text, {"middle", kFaint, 12});
            continue;
        }
        svg.raw(
            fmt::format("<text x=\"{0:.1f}\" y=\"{1:.1f}\" font-size=\"11\" "
                        "text-anchor=\"end\" fill=\"{2}\" transform=\"rotate(-38 {0:.1f} "
                        "{1:.1f})\">{3}</text>",
                        x + 4,
                        bottom + 14,
                        kFaint,
                        core::escape(tick.text)));
    }
    svg.line(plot.x, bottom, plot.x + plot.width, bottom, R"(stroke="#8a919c")");
    const std::string unit = axis.unit.empty() ? "" : ", " + axis.unit;
    const std::string log = axis.scale == studies::AxisScale::log ? ", logarithmic" : "";
    const double below = axis.scale == studies::AxisScale::named ? 38 + kNamedFoot : 38;
    svg.text(
        plot.x + plot.width / 2, bottom + below, axis.title + unit + log, {"middle", kFaint, 12});
    svg.vertical_text(plot.x - 44, plot.y + plot.height / 2, "error 1 − F", {.fill = kFaint});
}

void draw_ceiling(Svg& svg,
                  const StressScale& scale,
                  const std::vector<experiment::StressCurve>& curves) {
    for (const experiment::StressCurve& curve : curves) {
        if (curve.method != "sampled") continue;
        std::vector<double> xy;
        for (const experiment::StressPointSummary& point : curve.points) {
            if (!point.f) continue;
            xy.push_back(scale.x(point.value));
            xy.push_back(scale.y(*point.error()));
        }
        svg.polyline(xy, R"(stroke="#5b6470" stroke-width="1.4" stroke-dasharray="1.5 3")");
    }
}

void draw_line(Svg& svg,
               const StressScale& scale,
               const studies::StressAxis& axis,
               const Line& line) {
    std::vector<double> xy;
    for (const experiment::StressPointSummary& point : line.curve->points) {
        if (!point.f) continue;
        const double x = scale.x(point.value);
        const double y = scale.y(*point.error());
        xy.push_back(x);
        xy.push_back(y);
        if (point.f_range) {
            svg.line(x,
                     scale.y(1 - point.f_range->low),
                     x,
                     scale.y(1 - point.f_range->high),
                     fmt::format(R"(stroke="{}" stroke-width="1" opacity="0.4")", line.colour));
        }
        svg.raw(fmt::format("<g><title>{}: error {:.3f} at {}</title>",
                            core::escape(line.curve->method),
                            *point.error(),
                            core::escape(experiment::format_stress_value(axis, point.value))));
        svg.circle(x, y, 2.6, fmt::format(R"(fill="{}")", line.colour));
        svg.raw("</g>");
    }
    svg.polyline(xy,
                 fmt::format(R"(stroke="{}" stroke-width="1.8"{})",
                             line.colour,
                             line.is_tuned ? R"( stroke-dasharray="6 3")" : ""));
}

/// Names beside the lines' ends, pushed apart where those lie close.
void draw_names(Svg& svg, const StressScale& scale, const std::vector<Line>& lines) {
    struct Name {
        const Line* line;
        double end_x;
        double end_y;
        double y;
    };
    std::vector<Name> names;
    for (const Line& line : lines) {
        for (auto point = line.curve->points.rbegin(); point != line.curve->points.rend();
             ++point) {
            if (!point->f) continue;
            const double y = scale.y(*point->error());
            names.push_back({&line, scale.x(point->value), y, y});
            break;
        }
    }
    std::stable_sort(
        names.begin(), names.end(), [](auto& a, auto& b) { return a.end_y < b.end_y; });
    for (std::size_t i = 1; i < names.size(); ++i)
        names[i].y = std::max(names[i].y, names[i - 1].y + kLabelStep);
    const Box& plot = scale.plot();
    double lowest = plot.y + plot.height;
    for (auto name = names.rbegin(); name != names.rend(); ++name) {
        name->y = std::min(name->y, lowest);
        lowest = name->y - kLabelStep;
    }
    const double right = plot.x + plot.width;
    for (const Name& name : names) {
        svg.line(name.end_x + 4,
                 name.end_y,
                 right + 12,
                 name.y,
                 fmt::format(R"(stroke="{}" stroke-width="1" opacity="0.6")", name.line->colour));
        svg.text(right + 15,
                 name.y + 4,
                 name.line->curve->method,
                 {.fill = name.line->colour, .size = 12, .is_bold = true});
    }
}

}  // namespace

Svg stress_chart(const studies::StressAxis& axis,
                 const std::vector<experiment::StressCurve>& curves) {
    struct Panel {
        method::Family family;
        std::vector<Line> lines;
    };
    std::vector<Panel> panels;
    for (const method::Family family : method::kFamilies) {
        std::vector<Line> lines = lines_of(family, curves);
        if (family == method::Family::other && lines.empty()) continue;
        panels.push_back({family, std::move(lines)});
    }
    const double row_height =
        kPanelHeight + (axis.scale == studies::AxisScale::named ? kNamedFoot : 0);
    Svg svg(kWidth, static_cast<double>((panels.size() + 1) / 2) * row_height);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const Box plot{kLeft + kPanelWidth * static_cast<double>(i % 2),
                       kTop + row_height * static_cast<double>(i / 2),
                       kPlotWidth,
                       kPlotHeight};
        const StressScale scale(axis, curves, plot);
        const auto& [family, lines] = panels[i];
        draw_axes(svg, scale, axis, method::label_of(family));
        draw_ceiling(svg, scale, curves);
        for (const Line& line : lines)
            draw_line(svg, scale, axis, line);
        draw_names(svg, scale, lines);
    }
    return svg;
}

}  // namespace ink::report
