#include "report/scaling_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "core/escape.h"
#include "draw/palette.h"
#include "experiment/summary/scaling_steps.h"

namespace ink::report {
namespace {

constexpr double kWidth = 1000;
constexpr double kHeight = 400;
constexpr Box kPlot{84, 16, 790, 322};
constexpr double kMarker = 4.5;
constexpr double kLabelStep = 17;  // between the names of two lines
constexpr std::string_view kFaint = "#5b6470";
constexpr std::string_view kGrid = R"(stroke="#e6e8eb" stroke-width="1")";
constexpr std::string_view kFrame = R"(stroke="#8a919c" stroke-width="1")";

/// The points of one method, by x.
struct Line {
    std::string method;
    std::string_view colour;
    int shape = 0;  ///< of its markers, for more methods than colours
    std::vector<studies::ScalingPoint> points;
};

/// A range of one of the axes, in decimal logarithms.
struct Decades {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void take(double value) {
        low = std::min(low, std::log10(value));
        high = std::max(high, std::log10(value));
    }
    void pad(double share) {
        const double more = std::max((high - low) * share, 0.02);
        low -= more;
        high += more;
    }
    [[nodiscard]] double share(double value) const {
        return (std::log10(value) - low) / (high - low);
    }
    /// 1, 2 and 5 times the powers of ten inside; the powers alone where those are many.
    [[nodiscard]] std::vector<double> ticks() const {
        std::vector<double> inside;
        for (int decade = static_cast<int>(std::floor(low)); decade <= high; ++decade) {
            for (const int lead : {1, 2, 5}) {
                const double log = decade + std::log10(lead);
                if (log < low || log > high || (lead != 1 && high - low > 2.6)) continue;
                inside.push_back(lead * std::pow(10, decade));
            }
        }
        return inside;
    }
};

struct Scale {
    Decades x;
    Decades ns;

    [[nodiscard]] double x_at(double value) const { return kPlot.x + kPlot.width * x.share(value); }
    [[nodiscard]] double y_at(double time_ns) const {
        return kPlot.y + kPlot.height * (1 - ns.share(time_ns));
    }
};

std::vector<Line> lines_of(studies::ScalingAxis axis,
                           const std::vector<studies::ScalingPoint>& points) {
    std::vector<Line> lines;
    for (const studies::ScalingPoint& point : points) {
        auto at = std::find_if(lines.begin(), lines.end(), [&](const Line& line) {
            return line.method == point.method;
        });
        if (at == lines.end()) {
            const std::size_t i = lines.size();
            lines.push_back({point.method,
                             draw::kMethodColours[i % draw::kMethodColours.size()].hex,
                             static_cast<int>(i / draw::kMethodColours.size()),
                             {}});
            at = lines.end() - 1;
        }
        if (point.axis == axis && point.is_timed()) at->points.push_back(point);
    }
    for (Line& line : lines) {
        std::stable_sort(line.points.begin(),
                         line.points.end(),
                         [](const studies::ScalingPoint& a, const studies::ScalingPoint& b) {
                             return a.x < b.x;
                         });
    }
    lines.erase(
        std::remove_if(
            lines.begin(), lines.end(), [](const Line& line) { return line.points.empty(); }),
        lines.end());
    return lines;
}

Scale scale_of(const std::vector<Line>& lines) {
    Scale scale;
    for (const Line& line : lines) {
        for (const studies::ScalingPoint& point : line.points) {
            scale.x.take(point.x);
            scale.ns.take(static_cast<double>(point.draw_ns_min));
        }
    }
    scale.x.pad(0.03);
    scale.ns.pad(0.06);
    return scale;
}

std::string time_label(double time_ns) {
    if (time_ns < 999'500) return fmt::format("{:.3g} µs", time_ns / 1e3);
    if (time_ns < 999'500'000) return fmt::format("{:.3g} ms", time_ns / 1e6);
    return fmt::format("{:.3g} s", time_ns / 1e9);
}

void draw_axes(Svg& svg, const Scale& scale, const studies::ScalingAxisInfo& axis) {
    const double bottom = kPlot.y + kPlot.height;
    const double right = kPlot.x + kPlot.width;
    for (const double x : scale.x.ticks()) {
        svg.line(scale.x_at(x), kPlot.y, scale.x_at(x), bottom, kGrid);
        svg.text(scale.x_at(x),
                 bottom + 20,
                 experiment::format_scaling_x(axis.axis, x),
                 {"middle", kFaint});
    }
    for (const double ns : scale.ns.ticks()) {
        svg.line(kPlot.x, scale.y_at(ns), right, scale.y_at(ns), kGrid);
        svg.text(kPlot.x - 10, scale.y_at(ns) + 4.5, time_label(ns), {"end", kFaint});
    }
    svg.line(kPlot.x, bottom, right, bottom, kFrame);
    svg.line(kPlot.x, kPlot.y, kPlot.x, bottom, kFrame);
    svg.text(kPlot.x + kPlot.width / 2,
             bottom + 48,
             fmt::format("{}, logarithmic", axis.title),
             {"middle", kFaint});
    svg.vertical_text(
        16, kPlot.y + kPlot.height / 2, "least time of a frame, logarithmic", {.fill = kFaint});
}

/// A dashed line of slope 1 through the middle of the plot, as long as the plot allows.
void draw_guide(Svg& svg, const Scale& scale) {
    const double x_mid = (scale.x.low + scale.x.high) / 2;
    const double ns_mid = (scale.ns.low + scale.ns.high) / 2;
    const double reach = std::min(scale.x.high - scale.x.low, scale.ns.high - scale.ns.low) / 2;
    const auto at = [&](double along) {
        return std::pair(scale.x_at(std::pow(10, x_mid + along)),
                         scale.y_at(std::pow(10, ns_mid + along)));
    };
    const auto [x1, y1] = at(-reach);
    const auto [x2, y2] = at(reach);
    svg.line(x1, y1, x2, y2, R"(stroke="#8a919c" stroke-width="1.4" stroke-dasharray="6 5")");
    // Below its upper end, clear of it whether it leaves at the top or on the right.
    const bool is_flat = x2 > kPlot.x + kPlot.width - 60;
    svg.text(is_flat ? x2 - 4 : x2 + 10,
             is_flat ? y2 + 28 : y2 + 14,
             "linear",
             {is_flat ? "end" : "start", kFaint, 12});
}

void draw_marker(Svg& svg, double x, double y, const Line& line) {
    const std::string style =
        fmt::format(R"(fill="{}" stroke="#fff" stroke-width="1")", line.colour);
    const double r = kMarker;
    if (line.shape == 0) return svg.circle(x, y, r, style);
    if (line.shape == 1) return svg.rect({x - r, y - r, 2 * r, 2 * r}, style);
    svg.polygon({x, y - 1.3 * r, x + 1.3 * r, y, x, y + 1.3 * r, x - 1.3 * r, y}, style);
}

void draw_line(Svg& svg,
               const Scale& scale,
               const Line& line,
               const studies::ScalingAxisInfo& axis) {
    std::vector<double> xy;
    for (const studies::ScalingPoint& point : line.points) {
        xy.push_back(scale.x_at(point.x));
        xy.push_back(scale.y_at(static_cast<double>(point.draw_ns_min)));
    }
    svg.polyline(xy, fmt::format(R"(stroke="{}" stroke-width="2")", line.colour));
    for (const studies::ScalingPoint& point : line.points) {
        const auto ns = static_cast<double>(point.draw_ns_min);
        svg.raw(fmt::format("<g><title>{}: {} {}, {}</title>",
                            core::escape(line.method),
                            experiment::format_scaling_x(axis.axis, point.x),
                            axis.noun,
                            time_label(ns)));
        draw_marker(svg, scale.x_at(point.x), scale.y_at(ns), line);
        svg.raw("</g>");
    }
}

/// Names to the right of the lines' ends, pushed apart where those lie close.
void draw_names(Svg& svg, const Scale& scale, const std::vector<Line>& lines) {
    struct Name {
        const Line* line;
        double end_y;
        double y;
    };
    std::vector<Name> names;
    for (const Line& line : lines) {
        const double y = scale.y_at(static_cast<double>(line.points.back().draw_ns_min));
        names.push_back({&line, y, y});
    }
    std::stable_sort(
        names.begin(), names.end(), [](const Name& a, const Name& b) { return a.end_y < b.end_y; });
    const double bottom = kPlot.y + kPlot.height;
    for (std::size_t i = 1; i < names.size(); ++i)
        names[i].y = std::max(names[i].y, names[i - 1].y + kLabelStep);
    double lowest = bottom;
    for (auto name = names.rbegin(); name != names.rend(); ++name) {
        name->y = std::min(name->y, lowest);
        lowest = name->y - kLabelStep;
    }
    const double right = kPlot.x + kPlot.width;
    for (const Name& name : names) {
        const double end_x = scale.x_at(name.line->points.back().x);
        svg.line(end_x + kMarker + 2,
                 name.end_y,
                 right + 10,
                 name.y,
                 fmt::format(R"(stroke="{}" stroke-width="1" opacity="0.6")", name.line->colour));
        svg.text(
            right + 14, name.y + 4.5, name.line->method, {"start", name.line->colour, 13, true});
    }
}

}  // namespace

Svg scaling_chart(studies::ScalingAxis axis, const std::vector<studies::ScalingPoint>& points) {
    const std::vector<Line> lines = lines_of(axis, points);
    Svg svg(kWidth, lines.empty() ? 80 : kHeight);
    if (lines.empty()) {
        svg.text(kWidth / 2, 44, "No method was timed here.", {"middle", kFaint, 14});
        return svg;
    }
    const studies::ScalingAxisInfo& info = studies::scaling_axes()[static_cast<std::size_t>(axis)];
    const Scale scale = scale_of(lines);
    draw_axes(svg, scale, info);
    draw_guide(svg, scale);
    for (const Line& line : lines)
        draw_line(svg, scale, line, info);
    draw_names(svg, scale, lines);
    return svg;
}

}  // namespace ink::report
