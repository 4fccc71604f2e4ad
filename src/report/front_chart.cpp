#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/escape.h"
#include "core/text_table.h"
#include "report/charts.h"
#include "report/front_scale.h"
#include "report/label_places.h"
#include "report/method_looks.h"
#include "report/verdict.h"

namespace ink::report {
namespace {

constexpr double kMarker = 6;
constexpr double kLabelSize = 14;

/// A method on the chart: how it is told from the others.
struct Series {
    const experiment::MethodSweep* sweep = nullptr;
    Look look;

    [[nodiscard]] const experiment::SettingSummary* usual() const {
        const auto found =
            std::find_if(sweep->settings.begin(),
                         sweep->settings.end(),
                         [](const experiment::SettingSummary& s) { return s.is_default(); });
        return found == sweep->settings.end() ? nullptr : &*found;
    }
};

std::vector<Series> series_of(const experiment::Fronts& fronts) {
    std::vector<Series> series;
    for (const experiment::MethodSweep& sweep : fronts.methods)
        series.push_back({&sweep, look_of(sweep.method, series.size())});
    return series;
}

/// What the plot must show of a setting.
void widen(const experiment::SettingSummary& setting, FrontScale& scale) {
    double least = setting.draw_ms;
    double most = setting.draw_ms;
    double error = setting.error;
    if (setting.is_default() && setting.draw_ms_quartiles) {
        if (setting.draw_ms_quartiles->low > 0) least = setting.draw_ms_quartiles->low;
        most = std::max(most, setting.draw_ms_quartiles->high);
    }
    if (setting.error > 0) scale.error_min = std::min(scale.error_min, setting.error);
    if (setting.is_default() && setting.error_range) {
        error = std::max(error, setting.error_range->high);
    }
    scale.log_min = std::min(scale.log_min, std::log10(least));
    scale.log_max = std::max(scale.log_max, std::log10(most));
    scale.error_max = std::max(scale.error_max, error);
}

/// The ceiling is on the chart: what is there still to win.
void widen(const std::vector<experiment::MethodSummary>& baselines, FrontScale& scale) {
    for (const experiment::MethodSummary& s : baselines) {
        if (s.method == "sampled" && s.f_2px && *s.f_2px < 1)
            scale.error_min = std::min(scale.error_min, 1 - *s.f_2px);
    }
}

FrontScale scale_of(const std::vector<Series>& series,
                    const std::vector<experiment::MethodSummary>& baselines) {
    FrontScale scale{1e9, -1e9, 1, 0};
    for (const Series& s : series) {
        for (const experiment::SettingSummary& setting : s.sweep->settings)
            widen(setting, scale);
    }
    widen(baselines, scale);
    // Room for the labels; at least a factor of ten, so that noise does not look like a difference.
    const double middle = (scale.log_min + scale.log_max) / 2;
    const double half = std::max(0.5, (scale.log_max - scale.log_min) / 2 + 0.18);
    const double error_min = std::max(scale.error_min / 1.8, 1e-4);
    // Near the top of all there is, the random baseline and an empty picture are on the chart too.
    const double most = scale.error_max * 1.4;
    const double error_max = most > 0.7 ? 1.6 : std::max(most, 10 * error_min);
    return {middle - half, middle + half, std::min(error_min, error_max / 10), error_max};
}

/// A stair through points from the fastest to the best, from the plot's top to its right end.
void draw_stair(Svg& svg,
                const FrontScale& scale,
                const std::vector<experiment::CostPoint>& points,
                std::string_view style) {
    std::vector<double> xy;
    for (const experiment::CostPoint& point : points) {
        const double x = scale.x(point.time);
        const double y = scale.y(point.error);
        if (!xy.empty()) xy.insert(xy.end(), {x, xy.back()});
        xy.insert(xy.end(), {x, y});
    }
    if (xy.size() > 2) svg.polyline(xy, style);
}

/// At a given budget, the lowest error that some setting of some method reaches.
void draw_front_of_all(Svg& svg, const FrontScale& scale, const std::vector<Series>& series) {
    std::vector<experiment::CostPoint> all;
    for (const Series& s : series) {
        for (const experiment::SettingSummary& setting : s.sweep->settings) {
            if (setting.error <= scale.error_max) all.push_back({setting.draw_ms, setting.error});
        }
    }
    if (all.empty()) return;
    std::vector<experiment::CostPoint> front;
    for (const std::size_t index : experiment::pareto_front(all))
        front.push_back(all[index]);
    std::vector<experiment::CostPoint> stair = front;
    stair.insert(stair.begin(), {front.front().time, scale.error_max});
    stair.push_back({std::pow(10, scale.log_max), front.back().error});
    draw_stair(
        svg,
        scale,
        stair,
        R"(stroke="#d3d7dd" stroke-width="5" stroke-linejoin="round" stroke-linecap="round")");
}

void draw_front(Svg& svg, const FrontScale& scale, const Series& series) {
    std::vector<experiment::CostPoint> front;
    for (const std::size_t index : series.sweep->front) {
        const experiment::SettingSummary& setting = series.sweep->settings[index];
        if (setting.error > scale.error_max) continue;
        front.push_back({setting.draw_ms, setting.error});
    }
    draw_stair(svg,
               scale,
               front,
               fmt::format(R"(stroke="{}" stroke-width="1.6" stroke-linejoin="round")",
                           series.look.colour().hex));
}

/// A setting says what it is when it is pointed at.
void draw_setting(Svg& svg,
                  const FrontScale& scale,
                  const Series& series,
                  const experiment::SettingSummary& s) {
    if (s.error > scale.error_max) return;
    svg.raw(fmt::format("<g><title>{}: {}, {} ms, F {}</title>",
                        core::escape(series.sweep->method),
                        core::escape(s.is_default() ? "as it comes" : s.difference),
                        format_ms(s.draw_ms),
                        core::format_share(1 - s.error)));
    draw_marker(
        svg, scale.x(s.draw_ms), scale.y(s.error), s.is_default() ? kMarker : 3, series.look);
    svg.raw("</g>");
}

void draw_bars(Svg& svg,
               const FrontScale& scale,
               const Series& series,
               const experiment::SettingSummary& s) {
    const double x = scale.x(s.draw_ms);
    const double y = scale.y(s.error);
    const std::string stroke =
        fmt::format(R"(stroke="{}" stroke-width="1.6" opacity="0.6")", series.look.colour().hex);
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
void add_bars(const experiment::SettingSummary& s,
              const FrontScale& scale,
              std::vector<Box>& taken) {
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

void draw_labels(Svg& svg,
                 const FrontScale& scale,
                 const std::vector<Series>& series,
                 std::vector<Box> taken) {
    LabelRoom room{
        .inside = kFrontPlot, .taken = std::move(taken), .size = kLabelSize, .radius = kMarker + 2};
    std::vector<Named> named;
    for (const Series& s : series) {
        for (const experiment::SettingSummary& setting : s.sweep->settings) {
            room.taken.push_back(box_round(scale.x(setting.draw_ms), scale.y(setting.error), 3));
            if (setting.is_default()) add_bars(setting, scale, room.avoided);
        }
        const experiment::SettingSummary* usual = s.usual();
        if (usual == nullptr) usual = &s.sweep->settings.front();
        named.push_back({s.sweep->method, scale.x(usual->draw_ms), scale.y(usual->error)});
    }
    const std::vector<LabelPlace> places = place_labels(named, room);
    for (std::size_t i = 0; i < named.size(); ++i) {
        const Box& box = places[i].box;
        const std::string_view colour = series[i].look.colour().hex;
        if (places[i].has_leader) {
            svg.line(named[i].x,
                     named[i].y,
                     std::clamp(named[i].x, box.x, box.x + box.width),
                     std::clamp(named[i].y, box.y + 2, box.y + box.height - 2),
                     fmt::format(R"(stroke="{}" stroke-width="0.9")", colour));
        }
        svg.text(box.x + 1, box.y + kLabelSize, named[i].name, {"start", colour, kLabelSize, true});
    }
}

}  // namespace

Svg front_chart(const experiment::Fronts& fronts) {
    const std::vector<Series> series = series_of(fronts);
    Svg svg(kFrontWidth, series.empty() ? 80 : kFrontHeight);
    if (series.empty()) {
        svg.text(kFrontWidth / 2,
                 44,
                 "No method was both scored and timed.",
                 {"middle", kFaintText, 14});
        return svg;
    }
    const FrontScale scale = scale_of(series, fronts.baselines);
    draw_front_axes(svg, scale);
    draw_front_of_all(svg, scale, series);
    const std::vector<Box> taken = draw_levels(svg, scale, fronts.baselines);
    for (const Series& s : series)
        draw_front(svg, scale, s);
    for (const Series& s : series) {
        for (const experiment::SettingSummary& setting : s.sweep->settings) {
            if (!setting.is_default()) draw_setting(svg, scale, s, setting);
        }
    }
    for (const Series& s : series) {
        const experiment::SettingSummary* usual = s.usual();
        if (usual == nullptr) continue;
        draw_bars(svg, scale, s, *usual);
        draw_setting(svg, scale, s, *usual);
    }
    draw_labels(svg, scale, series, taken);
    return svg;
}

}  // namespace ink::report
