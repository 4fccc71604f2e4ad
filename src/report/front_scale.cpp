#include "report/front_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace ink::report {
namespace {

constexpr std::string_view kGrid = R"(stroke="#e6e8eb" stroke-width="1")";
constexpr std::string_view kAxis = R"(stroke="#8a919c" stroke-width="1")";

void draw_error_axis(Svg& svg, const FrontScale& scale) {
    const int last = static_cast<int>(std::ceil(std::log10(scale.error_max)));
    for (int decade = static_cast<int>(std::floor(std::log10(scale.error_min))); decade <= last;
         ++decade) {
        for (const int lead : {1, 2, 5}) {
            const double error = lead * std::pow(10, decade);
            if (error < 0.9999 * scale.error_min || error > 1.0001 * scale.error_max) continue;
            const double y = scale.y(error);
            svg.line(kFrontPlot.x, y, kFrontPlot.x + kFrontPlot.width, y, kGrid);
            svg.text(kFrontPlot.x - 10, y + 4.5, fmt::format("{:g}", error), {"end", kFaintText});
        }
    }
    const double bottom = kFrontPlot.y + kFrontPlot.height;
    svg.line(kFrontPlot.x, bottom, kFrontPlot.x + kFrontPlot.width, bottom, kAxis);
    svg.vertical_text(22,
                      kFrontPlot.y + kFrontPlot.height / 2,
                      "error 1 − F at 2 px, logarithmic  (lower is better)",
                      {.fill = kFaintText});
}

std::string tick_label(double ms) {
    return ms < 1 ? fmt::format("{:g} µs", ms * 1000) : fmt::format("{:g} ms", ms);
}

void draw_time_axis(Svg& svg, const FrontScale& scale) {
    const double bottom = kFrontPlot.y + kFrontPlot.height;
    const bool is_long = scale.log_max - scale.log_min > 3;
    for (int decade = static_cast<int>(std::floor(scale.log_min)); decade < scale.log_max;
         ++decade) {
        for (const int lead : {1, 2, 5}) {
            const double ms = lead * std::pow(10, decade);
            const double log_ms = std::log10(ms);
            if (log_ms < scale.log_min || log_ms > scale.log_max) continue;
            if (is_long && lead != 1) continue;
            svg.line(scale.x(ms), kFrontPlot.y, scale.x(ms), bottom, kGrid);
            svg.text(scale.x(ms), bottom + 21, tick_label(ms), {"middle", kFaintText});
        }
    }
    svg.text(kFrontPlot.x + kFrontPlot.width / 2,
             bottom + 50,
             "time to draw one frame, median over views, logarithmic  (further left is faster)",
             {"middle", kFaintText});
}

/// A row that is no method, across the chart.
struct Level {
    std::string label;
    double error = 0;
};

std::vector<Level> levels_of(const std::vector<experiment::MethodSummary>& baselines) {
    std::vector<Level> levels;
    const auto add = [&levels](const char* name, double f, const char* meaning) {
        levels.push_back({fmt::format("{}: {:.3f}, {}", name, 1 - f, meaning), 1 - f});
    };
    for (const experiment::MethodSummary& s : baselines) {
        if (!s.f_2px) continue;
        if (s.method == "none") add("none", *s.f_2px, "an empty image");
        if (s.method == "sampled")
            add("sampled", *s.f_2px, "the best that one sample a pixel can do");
        if (s.method != "oracle") continue;
        add("oracle", *s.f_2px, "the truth itself");
        if (s.f_random) add("random", *s.f_random, "a random image of as many pixels as the truth");
    }
    std::stable_sort(levels.begin(), levels.end(), [](const Level& a, const Level& b) {
        return a.error > b.error;
    });
    return levels;
}

/// The base line of a label no lower than `base` that no level's line runs through.
double clear_base(double base, const FrontScale& scale, const std::vector<Level>& levels) {
    for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
        const double y = scale.y(level->error);
        if (y > base - 13 && y < base + 3) base = y - 5;
    }
    return base;
}

}  // namespace

void draw_front_axes(Svg& svg, const FrontScale& scale) {
    draw_error_axis(svg, scale);
    draw_time_axis(svg, scale);
}

std::vector<Box> draw_levels(Svg& svg,
                             const FrontScale& scale,
                             const std::vector<experiment::MethodSummary>& baselines) {
    const std::vector<Level> levels = levels_of(baselines);
    constexpr double kSize = 12;
    constexpr double kStep = 16;
    const double right = kFrontPlot.x + kFrontPlot.width - 4;
    std::vector<Box> taken;
    double top = kFrontPlot.y + 13;
    double lowest_free = kFrontPlot.y + kFrontPlot.height - 5;
    for (const Level& level : levels) {
        if (level.error <= scale.error_max) continue;
        taken.push_back({right - text_width(level.label, kSize) - 14, top - kSize, 400, kStep});
        svg.text(right, top, "↑ " + level.label, {"end", kFaintText, kSize});
        top += kStep;
    }
    for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
        if (level->error > scale.error_max) continue;
        const double y = scale.y(level->error);
        svg.line(kFrontPlot.x,
                 y,
                 kFrontPlot.x + kFrontPlot.width,
                 y,
                 R"(stroke="#5b6470" stroke-width="1.2" stroke-dasharray="2 4")");
        const double base = clear_base(std::min(y - 5, lowest_free), scale, levels);
        taken.push_back({right - text_width(level->label, kSize), base - kSize, 400, kStep});
        svg.text(right, base, level->label, {"end", kFaintText, kSize});
        lowest_free = base - kStep;
    }
    return taken;
}

}  // namespace ink::report
