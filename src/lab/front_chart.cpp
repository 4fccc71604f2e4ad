#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lab/charts.h"
#include "lab/palette.h"
#include "lab/verdict.h"

namespace ink::lab {
namespace {

constexpr double kWidth = 1000;
constexpr double kHeight = 470;
constexpr Box kPlot{76, 22, 890, 382};
constexpr double kMarker = 6;
constexpr double kLabelSize = 14;
constexpr std::string_view kGrid = R"(stroke="#e6e8eb" stroke-width="1")";
constexpr std::string_view kAxis = R"(stroke="#8a919c" stroke-width="1")";
constexpr std::string_view kFaint = "#5b6470";

constexpr std::array kMethodColours = {kBlue, kVermilion, kGreen, kPurple, kOrange, kSky};

/// A method's place on the chart.
struct Point {
    const MethodSummary* summary = nullptr;
    double time_ms = 0;
    double error = 0;
    std::string_view colour;
};

std::vector<Point> points_of(const std::vector<MethodSummary>& summaries) {
    std::vector<Point> points;
    for (const MethodSummary& s : summaries) {
        if (s.is_bracket || !s.f_2px || !s.draw_ms || *s.draw_ms <= 0) continue;
        const Colour& colour = kMethodColours[points.size() % kMethodColours.size()];
        points.push_back({&s, *s.draw_ms, 1 - *s.f_2px, colour.hex});
    }
    return points;
}

/// Where values stand on the plot: time logarithmic to the right, error upwards from 0.
struct Scale {
    double log_min = 0;
    double log_max = 1;
    double error_max = 1;

    [[nodiscard]] double x(double time_ms) const {
        return kPlot.x + kPlot.width * (std::log10(time_ms) - log_min) / (log_max - log_min);
    }
    [[nodiscard]] double y(double error) const {
        return kPlot.y + kPlot.height * (1 - error / error_max);
    }
};

Scale scale_of(const std::vector<Point>& points) {
    double least = points.front().time_ms;
    double most = least;
    double error = 0;
    for (const Point& p : points) {
        const Interval times =
            p.summary->draw_ms_quartiles.value_or(Interval{p.time_ms, p.time_ms});
        least = std::min({least, p.time_ms, times.low > 0 ? times.low : p.time_ms});
        most = std::max({most, p.time_ms, times.high});
        error = std::max(error, p.error);
        if (p.summary->f_2px_range) error = std::max(error, 1 - p.summary->f_2px_range->low);
    }
    // Room for the labels; at least a factor of ten, so that noise does not look like a difference.
    const double middle = (std::log10(least) + std::log10(most)) / 2;
    const double half = std::max(0.5, (std::log10(most) - std::log10(least)) / 2 + 0.18);
    return {middle - half, middle + half, std::min(1.04, std::max(0.02, error * 1.15))};
}

/// 1, 2 or 5 times a power of ten that splits `range` into 4 to 10 steps.
double nice_step(double range) {
    const double raw = range / 5;
    const double power = std::pow(10, std::floor(std::log10(raw)));
    const double lead = raw / power;
    return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

void draw_error_axis(Svg& svg, const Scale& scale) {
    const double step = nice_step(scale.error_max);
    const int decimals = std::max(1, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    for (int i = 0; step * i <= scale.error_max + 1e-9; ++i) {
        const double y = scale.y(step * i);
        svg.line(kPlot.x, y, kPlot.x + kPlot.width, y, i == 0 ? kAxis : kGrid);
        svg.text(
            kPlot.x - 10, y + 4.5, fmt::format("{:.{}f}", step * i, decimals), {"end", kFaint});
    }
    svg.vertical_text(
        22, kPlot.y + kPlot.height / 2, "error 1 − F at 2 px  (lower is better)", {.fill = kFaint});
}

std::string tick_label(double ms) {
    return ms < 1 ? fmt::format("{:g} µs", ms * 1000) : fmt::format("{:g} ms", ms);
}

void draw_time_axis(Svg& svg, const Scale& scale) {
    const double bottom = kPlot.y + kPlot.height;
    const bool is_long = scale.log_max - scale.log_min > 3;
    for (int decade = static_cast<int>(std::floor(scale.log_min)); decade < scale.log_max;
         ++decade) {
        for (const int lead : {1, 2, 5}) {
            const double ms = lead * std::pow(10, decade);
            const double log_ms = std::log10(ms);
            if (log_ms < scale.log_min || log_ms > scale.log_max) continue;
            if (is_long && lead != 1) continue;
            svg.line(scale.x(ms), kPlot.y, scale.x(ms), bottom, kGrid);
            svg.text(scale.x(ms), bottom + 21, tick_label(ms), {"middle", kFaint});
        }
    }
    svg.text(kPlot.x + kPlot.width / 2,
             bottom + 50,
             "time to draw one frame, median over views, logarithmic  (further left is faster)",
             {"middle", kFaint});
}

/// The line of a bracket row across the plot, or a note at the top where it lies above.
void draw_bracket(Svg& svg, const Scale& scale, const MethodSummary& s, std::string_view meaning) {
    const double error = 1 - *s.f_2px;
    const std::string label = fmt::format("{}: {:.3f}, {}", s.method, error, meaning);
    const double right = kPlot.x + kPlot.width - 4;
    if (error > scale.error_max) {
        svg.text(right, kPlot.y + 11, "↑ " + label, {"end", kFaint, 12});
        return;
    }
    const double y = scale.y(error);
    svg.line(kPlot.x,
             y,
             kPlot.x + kPlot.width,
             y,
             R"(stroke="#5b6470" stroke-width="1.2" stroke-dasharray="2 4")");
    const bool is_low = y > kPlot.y + kPlot.height - 20;
    svg.text(right, is_low ? y - 5 : y + 15, label, {"end", kFaint, 12});
}

void draw_brackets(Svg& svg, const Scale& scale, const std::vector<MethodSummary>& summaries) {
    for (const MethodSummary& s : summaries) {
        if (!s.f_2px) continue;
        if (s.method == "none") draw_bracket(svg, scale, s, "an empty picture");
        if (s.method == "sampled") {
            draw_bracket(svg, scale, s, "the best that one sample a pixel can do");
        }
    }
}

/// A staircase: at a given budget, the lowest error that some method reaches.
void draw_front(Svg& svg, const Scale& scale, const std::vector<Point>& points) {
    std::vector<CostPoint> costs;
    for (const Point& p : points)
        costs.push_back({p.time_ms, p.error});
    std::vector<double> xy;
    for (const std::size_t index : pareto_front(costs)) {
        const double x = scale.x(costs[index].time);
        xy.insert(xy.end(), {x, xy.empty() ? kPlot.y : xy.back(), x, scale.y(costs[index].error)});
    }
    xy.insert(xy.end(), {kPlot.x + kPlot.width, xy.back()});
    svg.polyline(xy, R"(stroke="#b9bfc8" stroke-width="2" stroke-linejoin="round")");
}

void draw_point(Svg& svg, const Scale& scale, const Point& p) {
    const double x = scale.x(p.time_ms);
    const double y = scale.y(p.error);
    const std::string stroke =
        fmt::format(R"(stroke="{}" stroke-width="1.6" opacity="0.75")", p.colour);
    if (p.summary->draw_ms_quartiles && p.summary->draw_ms_quartiles->low > 0) {
        const Interval& times = *p.summary->draw_ms_quartiles;
        svg.line(scale.x(times.low), y, scale.x(times.high), y, stroke);
    }
    if (p.summary->f_2px_range) {
        const Interval& f = *p.summary->f_2px_range;
        svg.line(x, scale.y(1 - f.low), x, scale.y(1 - f.high), stroke);
    }
    svg.circle(
        x, y, kMarker, fmt::format(R"(fill="{}" stroke="#ffffff" stroke-width="1.5")", p.colour));
}

/// A label beside its marker, where it covers no other label and no other marker.
Box label_box(const Point& p, const Scale& scale, const std::vector<Box>& taken) {
    const double x = scale.x(p.time_ms);
    const double y = scale.y(p.error);
    const double width = text_width(p.summary->method, kLabelSize);
    const double height = kLabelSize + 3;
    const std::array<Box, 6> places = {{
        {x + 11, y - height - 3, width, height},
        {x + 11, y + 4, width, height},
        {x - 11 - width, y - height - 3, width, height},
        {x - 11 - width, y + 4, width, height},
        {x - width / 2, y - height - 22, width, height},
        {x - width / 2, y + 22, width, height},
    }};
    for (const Box& place : places) {
        const bool is_inside = place.x >= kPlot.x && place.x + width <= kPlot.x + kPlot.width &&
                               place.y >= kPlot.y && place.y + height <= kPlot.y + kPlot.height;
        const bool is_free = std::none_of(
            taken.begin(), taken.end(), [&](const Box& other) { return place.overlaps(other); });
        if (is_inside && is_free) return place;
    }
    return places[0];
}

void draw_labels(Svg& svg, const Scale& scale, const std::vector<Point>& points) {
    std::vector<Box> taken;
    for (const Point& p : points) {
        taken.push_back(
            {scale.x(p.time_ms) - kMarker, scale.y(p.error) - kMarker, 2 * kMarker, 2 * kMarker});
    }
    for (const Point& p : points) {
        const Box box = label_box(p, scale, taken);
        taken.push_back(box);
        const bool is_left = box.x < scale.x(p.time_ms);
        svg.text(is_left ? box.x + box.width : box.x,
                 box.y + kLabelSize,
                 p.summary->method,
                 {is_left ? "end" : "start", p.colour, kLabelSize, true});
    }
}

}  // namespace

Svg front_chart(const std::vector<MethodSummary>& summaries) {
    const std::vector<Point> points = points_of(summaries);
    Svg svg(kWidth, points.empty() ? 80 : kHeight);
    if (points.empty()) {
        svg.text(kWidth / 2, 44, "No method was both scored and timed.", {"middle", kFaint, 14});
        return svg;
    }
    const Scale scale = scale_of(points);
    draw_error_axis(svg, scale);
    draw_time_axis(svg, scale);
    draw_front(svg, scale, points);
    draw_brackets(svg, scale, summaries);
    for (const Point& p : points)
        draw_point(svg, scale, p);
    draw_labels(svg, scale, points);
    return svg;
}

}  // namespace ink::lab
