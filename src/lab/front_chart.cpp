#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lab/charts.h"
#include "lab/front_scale.h"
#include "lab/html.h"
#include "lab/palette.h"
#include "lab/verdict.h"

namespace ink::lab {
namespace {

constexpr double kMarker = 6;
constexpr double kLabelSize = 14;

/// A method on the chart: how it is told from the others.
struct Series {
    const MethodSweep* sweep = nullptr;
    std::string_view colour;
    int shape = 0;  ///< of its markers, for more methods than colours

    [[nodiscard]] const SettingSummary* usual() const {
        const auto found = std::find_if(sweep->settings.begin(),
                                        sweep->settings.end(),
                                        [](const SettingSummary& s) { return s.is_default(); });
        return found == sweep->settings.end() ? nullptr : &*found;
    }
};

std::vector<Series> series_of(const Fronts& fronts) {
    std::vector<Series> series;
    for (const MethodSweep& sweep : fronts.methods) {
        const std::size_t i = series.size();
        series.push_back({&sweep,
                          kMethodColours[i % kMethodColours.size()].hex,
                          static_cast<int>(i / kMethodColours.size())});
    }
    return series;
}

/// What the plot must show of a setting. One far worse than all methods as they come must not
/// squeeze these together: it may lie above the plot.
void widen(const SettingSummary& setting, FrontScale& scale) {
    double least = setting.draw_ms;
    double most = setting.draw_ms;
    double error = setting.is_default() ? setting.error : 0;
    if (setting.is_default() && setting.draw_ms_quartiles) {
        if (setting.draw_ms_quartiles->low > 0) least = setting.draw_ms_quartiles->low;
        most = std::max(most, setting.draw_ms_quartiles->high);
    }
    if (setting.is_default() && setting.error_range) {
        error = std::max(error, setting.error_range->high);
    }
    scale.log_min = std::min(scale.log_min, std::log10(least));
    scale.log_max = std::max(scale.log_max, std::log10(most));
    scale.error_max = std::max(scale.error_max, error);
}

FrontScale scale_of(const std::vector<Series>& series) {
    FrontScale scale{1e9, -1e9, 0};
    for (const Series& s : series) {
        for (const SettingSummary& setting : s.sweep->settings) {
            widen(setting, scale);
            if (s.usual() == nullptr) scale.error_max = std::max(scale.error_max, setting.error);
        }
    }
    // Room for the labels; at least a factor of ten, so that noise does not look like a difference.
    const double middle = (scale.log_min + scale.log_max) / 2;
    const double half = std::max(0.5, (scale.log_max - scale.log_min) / 2 + 0.18);
    const double error_max = std::min(1.04, std::max(0.02, scale.error_max * 1.15));
    return {middle - half, middle + half, error_max};
}

/// A stair through points from the fastest to the best, from the plot's top to its right end.
void draw_stair(Svg& svg,
                const FrontScale& scale,
                const std::vector<CostPoint>& points,
                std::string_view style) {
    std::vector<double> xy;
    for (const CostPoint& point : points) {
        const double x = scale.x(point.time);
        const double y = scale.y(point.error);
        if (!xy.empty()) xy.insert(xy.end(), {x, xy.back()});
        xy.insert(xy.end(), {x, y});
    }
    if (xy.size() > 2) svg.polyline(xy, style);
}

/// At a given budget, the lowest error that some setting of some method reaches.
void draw_front_of_all(Svg& svg, const FrontScale& scale, const std::vector<Series>& series) {
    std::vector<CostPoint> all;
    for (const Series& s : series) {
        for (const SettingSummary& setting : s.sweep->settings) {
            if (setting.error <= scale.error_max) all.push_back({setting.draw_ms, setting.error});
        }
    }
    if (all.empty()) return;
    std::vector<CostPoint> front;
    for (const std::size_t index : pareto_front(all))
        front.push_back(all[index]);
    std::vector<CostPoint> stair = front;
    stair.insert(stair.begin(), {front.front().time, scale.error_max});
    stair.push_back({std::pow(10, scale.log_max), front.back().error});
    draw_stair(
        svg,
        scale,
        stair,
        R"(stroke="#d3d7dd" stroke-width="5" stroke-linejoin="round" stroke-linecap="round")");
}

void draw_front(Svg& svg, const FrontScale& scale, const Series& series) {
    std::vector<CostPoint> front;
    for (const std::size_t index : series.sweep->front) {
        const SettingSummary& setting = series.sweep->settings[index];
        if (setting.error > scale.error_max) continue;
        front.push_back({setting.draw_ms, setting.error});
    }
    draw_stair(
        svg,
        scale,
        front,
        fmt::format(R"(stroke="{}" stroke-width="1.6" stroke-linejoin="round")", series.colour));
}

void draw_marker(Svg& svg, double x, double y, double radius, const Series& series) {
    const std::string style = fmt::format(
        R"(fill="{}" stroke="#ffffff" stroke-width="{}")", series.colour, radius > 4 ? 1.5 : 0.6);
    const double r = radius;
    switch (series.shape % 4) {
        case 1:
            return svg.rect({x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r}, style);
        case 2:
            return svg.polygon({x, y - 1.3 * r, x + 1.3 * r, y, x, y + 1.3 * r, x - 1.3 * r, y},
                               style);
        case 3:
            return svg.polygon({x, y - 1.2 * r, x + 1.2 * r, y + r, x - 1.2 * r, y + r}, style);
        default:
            return svg.circle(x, y, r, style);
    }
}

/// A setting says what it is when it is pointed at.
void draw_setting(Svg& svg,
                  const FrontScale& scale,
                  const Series& series,
                  const SettingSummary& s) {
    if (s.error > scale.error_max) return;
    svg.raw(fmt::format("<g><title>{}: {}, {} ms, F {}</title>",
                        escape(series.sweep->method),
                        escape(s.is_default() ? "as it comes" : s.difference),
                        format_ms(s.draw_ms),
                        format_share(1 - s.error)));
    draw_marker(svg, scale.x(s.draw_ms), scale.y(s.error), s.is_default() ? kMarker : 3, series);
    svg.raw("</g>");
}

void draw_bars(Svg& svg, const FrontScale& scale, const Series& series, const SettingSummary& s) {
    const double x = scale.x(s.draw_ms);
    const double y = scale.y(s.error);
    const std::string stroke =
        fmt::format(R"(stroke="{}" stroke-width="1.6" opacity="0.6")", series.colour);
    if (s.draw_ms_quartiles && s.draw_ms_quartiles->low > 0) {
        svg.line(
            scale.x(s.draw_ms_quartiles->low), y, scale.x(s.draw_ms_quartiles->high), y, stroke);
    }
    if (s.error_range) {
        svg.line(x, scale.y(s.error_range->low), x, scale.y(s.error_range->high), stroke);
    }
}

Box box_round(double x, double y, double radius) {
    return {x - radius, y - radius, 2 * radius, 2 * radius};
}

/// Where the bars of draw_bars() stand.
void add_bars(const SettingSummary& s, const FrontScale& scale, std::vector<Box>& taken) {
    constexpr double kThick = 3;
    const double x = scale.x(s.draw_ms);
    const double y = scale.y(s.error);
    if (s.draw_ms_quartiles && s.draw_ms_quartiles->low > 0) {
        const double left = scale.x(s.draw_ms_quartiles->low);
        const double right = scale.x(s.draw_ms_quartiles->high);
        taken.push_back({left, y - kThick / 2, right - left, kThick});
    }
    if (s.error_range) {
        const double top = scale.y(s.error_range->high);
        const double bottom = scale.y(s.error_range->low);
        taken.push_back({x - kThick / 2, top, kThick, bottom - top});
    }
}

/// A label beside its marker, where it covers no other label and no marker.
Box label_box(const std::string& label, double x, double y, const std::vector<Box>& taken) {
    const double width = text_width(label, kLabelSize);
    const double height = kLabelSize + 3;
    std::vector<Box> places;
    for (const double away : {3.0, 20.0, 38.0, 58.0, 80.0}) {
        for (const double left : {x + 11, x - 11 - width, x - width / 2}) {
            places.push_back({left, y - height - away, width, height});
            places.push_back({left, y + away + 1, width, height});
        }
    }
    for (const Box& place : places) {
        const bool is_inside =
            place.x >= kFrontPlot.x && place.x + width <= kFrontPlot.x + kFrontPlot.width &&
            place.y >= kFrontPlot.y && place.y + height <= kFrontPlot.y + kFrontPlot.height;
        const bool is_free = std::none_of(
            taken.begin(), taken.end(), [&](const Box& other) { return place.overlaps(other); });
        if (is_inside && is_free) return place;
    }
    return places[0];
}

void draw_labels(Svg& svg,
                 const FrontScale& scale,
                 const std::vector<Series>& series,
                 std::vector<Box> taken) {
    for (const Series& s : series) {
        for (const SettingSummary& setting : s.sweep->settings) {
            const double radius = setting.is_default() ? kMarker : 3;
            taken.push_back(box_round(scale.x(setting.draw_ms), scale.y(setting.error), radius));
            if (setting.is_default()) add_bars(setting, scale, taken);
        }
    }
    for (const Series& s : series) {
        const SettingSummary* usual = s.usual();
        if (usual == nullptr) usual = &s.sweep->settings.front();
        const double x = scale.x(usual->draw_ms);
        const Box box = label_box(s.sweep->method, x, scale.y(usual->error), taken);
        taken.push_back(box);
        svg.text(box.x, box.y + kLabelSize, s.sweep->method, {"start", s.colour, kLabelSize, true});
    }
}

}  // namespace

Svg front_chart(const Fronts& fronts) {
    const std::vector<Series> series = series_of(fronts);
    Svg svg(kFrontWidth, series.empty() ? 80 : kFrontHeight);
    if (series.empty()) {
        svg.text(kFrontWidth / 2,
                 44,
                 "No method was both scored and timed.",
                 {"middle", kFaintText, 14});
        return svg;
    }
    const FrontScale scale = scale_of(series);
    draw_front_axes(svg, scale);
    draw_front_of_all(svg, scale, series);
    const std::vector<Box> taken = draw_levels(svg, scale, fronts.brackets);
    for (const Series& s : series)
        draw_front(svg, scale, s);
    for (const Series& s : series) {
        for (const SettingSummary& setting : s.sweep->settings) {
            if (!setting.is_default()) draw_setting(svg, scale, s, setting);
        }
    }
    for (const Series& s : series) {
        const SettingSummary* usual = s.usual();
        if (usual == nullptr) continue;
        draw_bars(svg, scale, s, *usual);
        draw_setting(svg, scale, s, *usual);
    }
    draw_labels(svg, scale, series, taken);
    return svg;
}

}  // namespace ink::lab
