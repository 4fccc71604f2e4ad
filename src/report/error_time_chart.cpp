#include "report/error_time_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/label_places.h"
#include "report/method_looks.h"

namespace ink::report {
namespace {

constexpr double kWidth = 560;
constexpr double kHeight = 470;
constexpr Box kPlot{58, 40, 490, 376};
constexpr double kSize = 13;
constexpr double kLabelSize = 12.5;
constexpr double kMarker = 6;
constexpr std::string_view kSoft = "#4b535e";
constexpr std::string_view kGrid = R"(stroke="#e6e8eb" stroke-width="1")";
constexpr std::string_view kFrame = R"(fill="none" stroke="#8a919c" stroke-width="1")";

/// A logarithmic axis from `low` to `high`, both above 0.
struct LogAxis {
    double low = 1;
    double high = 10;

    [[nodiscard]] double share(double value) const {
        return std::log(std::max(value, low) / low) / std::log(high / low);
    }
    /// 1, 2 and 5 times powers of ten on the axis; over long axes powers of ten alone.
    [[nodiscard]] std::vector<double> ticks() const {
        std::vector<double> values;
        const bool is_long = high / low > 2500;
        const int last = static_cast<int>(std::ceil(std::log10(high)));
        for (int decade = static_cast<int>(std::floor(std::log10(low))); decade <= last; ++decade) {
            for (const int lead : {1, 2, 5}) {
                const double value = lead * std::pow(10, decade);
                const bool is_inside = value >= low * 0.9999 && value <= high * 1.0001;
                if (is_inside && (lead == 1 || !is_long)) values.push_back(value);
            }
        }
        return values;
    }
};

struct Scale {
    LogAxis time_ms;
    LogAxis error;  ///< 0..1

    [[nodiscard]] double x(double ms) const { return kPlot.x + kPlot.width * time_ms.share(ms); }
    [[nodiscard]] double y(double e) const {
        return kPlot.y + kPlot.height * (1 - std::min(1.0, error.share(e)));
    }
};

Scale scale_of(const std::vector<TimedError>& points, std::optional<double> sampled_error) {
    Scale scale{{1e9, 0}, {1, 0}};
    const auto widen_time = [&](double ms) {
        if (ms > 0) scale.time_ms.low = std::min(scale.time_ms.low, ms);
        scale.time_ms.high = std::max(scale.time_ms.high, ms);
    };
    for (const TimedError& p : points) {
        widen_time(p.draw_ms);
        if (p.draw_ms_range) {
            widen_time(p.draw_ms_range->low);
            widen_time(p.draw_ms_range->high);
        }
        if (p.error > 0) scale.error.low = std::min(scale.error.low, p.error);
        scale.error.high =
            std::max({scale.error.high, p.error, p.error_range ? p.error_range->high : 0.0});
    }
    if (sampled_error && *sampled_error > 0)
        scale.error.low = std::min(scale.error.low, *sampled_error);
    scale.error.low = std::max(scale.error.low / 1.7, 1e-4);
    scale.error.high = std::min(std::max(scale.error.high * 1.15, scale.error.low * 10), 1.0);
    scale.error.low = std::min(scale.error.low, scale.error.high / 10);
    // Room for labels; at least a factor of ten, so that noise does not look like a difference.
    const double middle = std::sqrt(scale.time_ms.low * scale.time_ms.high);
    const double half =
        std::max(std::sqrt(10), std::sqrt(scale.time_ms.high / scale.time_ms.low) * 1.25);
    scale.time_ms = {middle / half, middle * half};
    return scale;
}

void draw_axes(Svg& svg, const Scale& scale) {
    const double bottom = kPlot.y + kPlot.height;
    for (const double ms : scale.time_ms.ticks()) {
        svg.line(scale.x(ms), kPlot.y, scale.x(ms), bottom, kGrid);
        svg.text(scale.x(ms), bottom + 18, fmt::format("{:g}", ms), {"middle", kSoft, kSize});
    }
    for (const double error : scale.error.ticks()) {
        const double y = scale.y(error);
        svg.line(kPlot.x, y, kPlot.x + kPlot.width, y, kGrid);
        svg.text(kPlot.x - 7, y + 4.5, fmt::format("{:g}", 100 * error), {"end", kSoft, kSize});
    }
    svg.rect(kPlot, kFrame);
    svg.text(kPlot.x + kPlot.width / 2,
             bottom + 40,
             "time to draw a frame (ms)",
             {"middle", "#20242a", kSize});
    svg.vertical_text(16, kPlot.y + kPlot.height / 2, "error 1 − F at 2 px (%)", {.size = kSize});
}

/// The lowest error to be had at each time.
void draw_front(Svg& svg, const Scale& scale, const std::vector<TimedError>& points) {
    std::vector<experiment::CostPoint> costs;
    for (const TimedError& p : points)
        costs.push_back({p.draw_ms, p.error});
    std::vector<double> xy;
    for (const std::size_t index : experiment::pareto_front(costs)) {
        const double x = scale.x(costs[index].time);
        const double y = scale.y(costs[index].error);
        xy.insert(xy.end(), {x, xy.empty() ? kPlot.y : xy.back(), x, y});
    }
    xy.insert(xy.end(), {kPlot.x + kPlot.width, xy.back()});
    svg.polyline(xy, R"(stroke="#d3d7dd" stroke-width="5" stroke-linejoin="round")");
}

/// The bars of a point: time lying, error standing.
std::vector<Box> bars_of(const Scale& scale, const TimedError& p) {
    std::vector<Box> bars;
    const double x = scale.x(p.draw_ms);
    const double y = scale.y(p.error);
    if (p.draw_ms_range) {
        const double left = scale.x(p.draw_ms_range->low);
        bars.push_back({left, y - 0.8, scale.x(p.draw_ms_range->high) - left, 1.6});
    }
    if (p.error_range) {
        const double top = scale.y(p.error_range->high);
        bars.push_back({x - 0.8, top, 1.6, scale.y(p.error_range->low) - top});
    }
    return bars;
}

/// Families at the top, in their colours.
void draw_families(Svg& svg, const std::vector<Look>& looks) {
    double x = kPlot.x;
    const auto put = [&](const Look& look, std::string_view words) {
        draw_marker(svg, x + 6, 20, 5, look);
        svg.text(x + 16, 24.5, words, {"start", look.colour().hex, 12});
        x += 16 + text_width(words, 12) * 0.92 + 12;
    };
    for (const method::Family family : method::kFamilies) {
        const bool is_there = std::any_of(
            looks.begin(), looks.end(), [&](const Look& look) { return look.family == family; });
        if (is_there) put({family, method::Marker::circle, false}, method::label_of(family));
    }
    const bool has_tuned =
        std::any_of(looks.begin(), looks.end(), [](const Look& look) { return look.is_hollow; });
    if (has_tuned) put({method::Family::other, method::Marker::circle, true}, "tuned");
}

void draw_labels(Svg& svg,
                 const std::vector<Named>& named,
                 const std::vector<Look>& looks,
                 const LabelRoom& room) {
    const std::vector<LabelPlace> places = place_labels(named, room);
    for (std::size_t i = 0; i < named.size(); ++i) {
        const Box& box = places[i].box;
        const double x = std::clamp(named[i].x, box.x, box.x + box.width);
        const double y = std::clamp(named[i].y, box.y + 2, box.y + box.height - 2);
        if (places[i].has_leader) {
            svg.line(named[i].x,
                     named[i].y,
                     x,
                     y,
                     fmt::format(R"(stroke="{}" stroke-width="0.8")", looks[i].colour().hex));
        }
    }
    for (std::size_t i = 0; i < named.size(); ++i) {
        const Box& box = places[i].box;
        svg.text(box.x + box.width / 2,
                 box.y + room.size - 0.5,
                 named[i].name,
                 {"middle", "#20242a", room.size});
    }
}

}  // namespace

std::vector<TimedError> timed_errors(const std::vector<experiment::MethodSummary>& summaries) {
    std::vector<TimedError> points;
    for (const experiment::MethodSummary& s : summaries) {
        if (s.is_baseline || !s.f_2px || !s.draw_ms || *s.draw_ms <= 0) continue;
        TimedError point{s.method, *s.draw_ms, s.draw_ms_quartiles, 1 - *s.f_2px};
        if (s.f_2px_range)
            point.error_range =
                statistics::Interval{1 - s.f_2px_range->high, 1 - s.f_2px_range->low};
        points.push_back(std::move(point));
    }
    return points;
}

Svg error_time_chart(const std::vector<TimedError>& points, std::optional<double> sampled_error) {
    Svg svg(kWidth, points.empty() ? 80 : kHeight);
    if (points.empty()) {
        svg.text(kWidth / 2, 44, "No method was both scored and timed.", {"middle", kSoft, kSize});
        return svg;
    }
    const Scale scale = scale_of(points, sampled_error);
    draw_axes(svg, scale);
    draw_front(svg, scale, points);
    LabelRoom room{.inside = {kPlot.x + 2, kPlot.y + 2, kPlot.width - 4, kPlot.height - 4},
                   .size = kLabelSize,
                   .radius = kMarker + 1};
    if (sampled_error) {
        const double y = scale.y(*sampled_error);
        constexpr std::string_view kWords = "one exact sample a pixel";
        svg.line(kPlot.x,
                 y,
                 kPlot.x + kPlot.width,
                 y,
                 R"(stroke="#5b6470" stroke-width="1.2" stroke-dasharray="2 4")");
        svg.text(kPlot.x + 6, y - 4, kWords, {"start", kSoft, 11.5});
        room.taken.push_back({kPlot.x, y - 15, text_width(kWords, 11.5) + 6, 15});
    }
    std::vector<Look> looks;
    std::vector<Named> named;
    for (const TimedError& p : points) {
        looks.push_back(look_of(p.method, looks.size()));
        named.push_back({p.method, scale.x(p.draw_ms), scale.y(p.error)});
        for (const Box& bar : bars_of(scale, p)) {
            room.avoided.push_back(bar);
            svg.rect(bar, fmt::format(R"(fill="{}" opacity="0.38")", looks.back().colour().hex));
        }
    }
    draw_families(svg, looks);
    draw_labels(svg, named, looks, room);
    for (std::size_t i = 0; i < points.size(); ++i)
        draw_marker(svg, named[i].x, named[i].y, kMarker, looks[i]);
    return svg;
}

}  // namespace ink::report
