#include "report/motion_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/escape.h"
#include "experiment/summary/summary.h"

namespace ink::report {
namespace {

constexpr double kWidth = 1000;
constexpr double kGutter = 128;  // method names
constexpr double kPanelGap = 26;
constexpr double kTop = 46;  // panel headings
constexpr double kRowHeight = 27;
constexpr double kBarHeight = 16;
constexpr double kValueWidth = 46;  // room for a value beside the longest bar
constexpr double kBottom = 26;      // tick labels
constexpr std::string_view kFaint = "#6b7280";

/// A stretch of a bar.
struct Piece {
    double length = 0;  ///< in the panel's unit
    std::string_view hex;
    std::string title;
};

/// One of the three panels: what its bars are made of.
struct Panel {
    std::string heading;
    std::vector<std::vector<Piece>> bars;  ///< one per method; none where there is no value
};

double sum_of(const std::vector<Piece>& bar) {
    double sum = 0;
    for (const Piece& piece : bar)
        sum += piece.length;
    return sum;
}

/// 1, 2 or 5 times a power of ten, as large as the longest bar needs.
double scale_end(const Panel& panel) {
    double longest = 0;
    for (const auto& bar : panel.bars)
        longest = std::max(longest, sum_of(bar));
    if (longest <= 0) return 1;
    const double decade = std::pow(10, std::floor(std::log10(longest)));
    for (const double lead : {1.0, 2.0, 5.0}) {
        if (longest <= lead * decade) return lead * decade;
    }
    return 10 * decade;
}

Panel flicker_panel(const std::vector<studies::MotionTotal>& totals) {
    Panel panel{.heading = "flicker, ‰ of the drawn pixels a frame", .bars = {}};
    for (const studies::MotionTotal& t : totals) {
        std::vector<Piece> bar;
        if (t.flicker.n_counted > 0) {
            const double per_mille = 1000.0 / static_cast<double>(t.flicker.n_counted);
            bar.push_back({per_mille * static_cast<double>(t.flicker.appeared),
                           draw::kBlue.hex,
                           fmt::format("appeared: {} px", t.flicker.appeared)});
            bar.push_back({per_mille * static_cast<double>(t.flicker.disappeared),
                           draw::kSky.hex,
                           fmt::format("disappeared: {} px", t.flicker.disappeared)});
        }
        panel.bars.push_back(std::move(bar));
    }
    return panel;
}

Panel pop_panel(const std::vector<studies::MotionTotal>& totals) {
    Panel panel{.heading = "pops per feature and minute", .bars = {}};
    for (const studies::MotionTotal& t : totals) {
        std::vector<Piece> bar;
        if (const auto per_second = t.pops.per_second(t.frames_per_s)) {
            bar.push_back({60 * *per_second,
                           draw::kGreen.hex,
                           fmt::format("{} pops of {} features", t.pops.pops, t.pops.runs)});
        }
        panel.bars.push_back(std::move(bar));
    }
    return panel;
}

Panel life_panel(const std::vector<studies::MotionTotal>& totals) {
    Panel panel{.heading = "false lines per frame, by life", .bars = {}};
    for (const studies::MotionTotal& t : totals) {
        std::vector<Piece> bar;
        const auto counts = lives_by_class(t.lives);
        for (std::size_t i = 0; i < counts.size() && t.frames > 0; ++i) {
            bar.push_back({static_cast<double>(counts[i]) / t.frames,
                           kLifeClasses[i].colour.hex,
                           fmt::format("{}: {} lines", kLifeClasses[i].label, counts[i])});
        }
        panel.bars.push_back(std::move(bar));
    }
    return panel;
}

void draw_bar(Svg& svg, const Box& track, const std::vector<Piece>& bar, double end) {
    svg.rect(track, R"(fill="#f4f5f6")");
    double x = track.x;
    for (const Piece& piece : bar) {
        if (piece.length <= 0) continue;
        const double length = track.width * piece.length / end;
        svg.raw(fmt::format(
            R"(<rect x="{:.1f}" y="{:.1f}" width="{:.2f}" height="{:.1f}" fill="{}"><title>{}</title></rect>)",
            x,
            track.y,
            length,
            track.height,
            piece.hex,
            core::escape(piece.title)));
        x += length;
    }
    const std::string value = bar.empty() ? "–" : fmt::format("{:.3g}", sum_of(bar));
    svg.text(x + 6, track.y + 13, value, {.size = 12});
}

void draw_panel(Svg& svg, const Box& box, const Panel& panel) {
    const double end = scale_end(panel);
    const double full = box.width - kValueWidth;
    svg.text(box.x, 20, panel.heading, {.is_bold = true});
    for (int tick = 0; tick <= 2; ++tick) {
        const double x = box.x + full * tick / 2;
        svg.line(x, box.y - 6, x, box.y + box.height, R"(stroke="#e2e4e8")");
        svg.text(x,
                 box.y + box.height + 17,
                 fmt::format("{:g}", end * tick / 2),
                 {"middle", kFaint, 12});
    }
    for (std::size_t i = 0; i < panel.bars.size(); ++i) {
        const double y = box.y + kRowHeight * static_cast<double>(i) + 5;
        draw_bar(svg, {box.x, y, full, kBarHeight}, panel.bars[i], end);
    }
}

}  // namespace

std::array<std::int64_t, kLifeClasses.size()> lives_by_class(
    const std::vector<std::int64_t>& lives) {
    std::array<std::int64_t, kLifeClasses.size()> counts{};
    for (std::size_t i = 0; i < lives.size(); ++i) {
        std::size_t of = 0;
        while (of + 1 < kLifeClasses.size() &&
               kLifeClasses[of + 1].first <= static_cast<int>(i) + 1)
            ++of;
        counts[of] += lives[i];
    }
    return counts;
}

Svg motion_chart(const std::vector<studies::MotionTotal>& totals) {
    const double rows = std::max<double>(1, static_cast<double>(totals.size()));
    const double height = kTop + kRowHeight * rows + kBottom;
    Svg svg(kWidth, height);
    if (totals.empty()) {
        svg.text(kWidth / 2, height / 2, "No sequence was drawn.", {"middle", kFaint, 14});
        return svg;
    }
    for (std::size_t i = 0; i < totals.size(); ++i) {
        const std::string& name = totals[i].method;
        svg.text(kGutter - 14,
                 kTop + kRowHeight * static_cast<double>(i) + 18,
                 name.size() <= 15 ? name : name.substr(0, 14) + "~",
                 {"end", harness::is_baseline(name) ? kFaint : "#20242a"});
    }
    const std::array panels = {flicker_panel(totals), pop_panel(totals), life_panel(totals)};
    const double width = (kWidth - kGutter - 2 * kPanelGap) / 3;
    double x = kGutter;
    for (const Panel& panel : panels) {
        draw_panel(svg, {x, kTop, width, kRowHeight * rows}, panel);
        x += width + kPanelGap;
    }
    return svg;
}

}  // namespace ink::report
