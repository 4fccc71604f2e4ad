#include "report/cause_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "draw/palette.h"
#include "experiment/summary/summary.h"

namespace ink::report {
namespace {

constexpr double kWidth = 1000;
constexpr double kGutter = 128;  // method names
constexpr double kPanelGap = 40;
constexpr double kTop = 46;  // panel headings
constexpr double kRowHeight = 27;
constexpr double kBarHeight = 16;
constexpr double kValueWidth = 54;  // room for a value beside the longest bar
constexpr double kBottom = 26;      // tick labels

/// One half of the chart: how its bars are put together.
struct Side {
    std::string_view heading;
    std::span<const score::Cause> causes;
    std::int64_t experiment::CauseTotals::*whole;      ///< what the bars are shares of
    std::int64_t experiment::CauseTotals::*contested;  ///< unmatched beside a found line
    std::string_view contested_name;
};

const std::array<Side, 2>& sides() {
    static const std::array<Side, 2> kSides = {{
        {"not found, share of the true pixels",
         score::kFalseNegativeCauses,
         &experiment::CauseTotals::n_truth,
         &experiment::CauseTotals::unmatched_truth,
         "unmatched truth beside a drawn line"},
        {"drawn wrongly, share of the drawn pixels",
         score::kFalsePositiveCauses,
         &experiment::CauseTotals::n_pred,
         &experiment::CauseTotals::unmatched_duplicates,
         "unmatched duplicates beside a true line"},
    }};
    return kSides;
}

double share(std::int64_t part, std::int64_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

double share_of_side(const experiment::CauseTotals& totals, const Side& side) {
    std::int64_t wrong = totals.*side.contested;
    for (const score::Cause cause : side.causes)
        wrong += totals.causes[cause];
    return share(wrong, totals.*side.whole);
}

/// The scale's end: 5, 10, 20, 50 or 100 %, whatever the longest bar needs.
double scale_end(const std::vector<experiment::CauseTotals>& totals) {
    double longest = 0;
    for (const experiment::CauseTotals& t : totals) {
        for (const Side& side : sides())
            longest = std::max(longest, share_of_side(t, side));
    }
    for (const double end : {0.05, 0.1, 0.2, 0.5}) {
        if (longest <= end) return end;
    }
    return 1;
}

void draw_bar(Svg& svg,
              const Box& track,
              const experiment::CauseTotals& totals,
              const Side& side,
              double end) {
    svg.rect(track, R"(fill="#f4f5f6")");
    double x = track.x;
    const auto piece = [&](std::int64_t count, std::string_view hex, std::string_view name) {
        if (count == 0) return;
        const double part = share(count, totals.*side.whole);
        const double length = track.width * part / end;
        svg.raw(fmt::format(
            R"(<rect x="{:.1f}" y="{:.1f}" width="{:.2f}" height="{:.1f}" fill="{}"><title>{}: {} px, {:.2f} %</title></rect>)",
            x,
            track.y,
            length,
            track.height,
            hex,
            name,
            count,
            100 * part));
        x += length;
    };
    for (const score::Cause cause : side.causes)
        piece(totals.causes[cause], draw::colour_of(cause).hex, experiment::label_of(cause));
    piece(totals.*side.contested, draw::kMist.hex, side.contested_name);
    svg.text(x + 6,
             track.y + 13,
             fmt::format("{:.1f} %", 100 * share_of_side(totals, side)),
             {.size = 12});
}

void draw_side(Svg& svg,
               const Box& panel,
               const Side& side,
               const std::vector<experiment::CauseTotals>& totals) {
    const double end = scale_end(totals);
    const double full = panel.width - kValueWidth;
    svg.text(panel.x, 20, side.heading, {.is_bold = true});
    for (int tick = 0; tick <= 5; ++tick) {
        const double x = panel.x + full * tick / 5;
        svg.line(x, panel.y - 6, x, panel.y + panel.height, R"(stroke="#e2e4e8")");
        svg.text(x,
                 panel.y + panel.height + 17,
                 fmt::format("{:g} %", 100 * end * tick / 5),
                 {"middle", "#6b7280", 12});
    }
    for (std::size_t i = 0; i < totals.size(); ++i) {
        const double y = panel.y + kRowHeight * static_cast<double>(i) + 5;
        draw_bar(svg, {panel.x, y, full, kBarHeight}, totals[i], side, end);
    }
}

}  // namespace

Svg cause_chart(const std::vector<experiment::CauseTotals>& totals) {
    const double rows = std::max<double>(1, static_cast<double>(totals.size()));
    const double height = kTop + kRowHeight * rows + kBottom;
    Svg svg(kWidth, height);
    if (totals.empty()) {
        svg.text(kWidth / 2, height / 2, "No method was scored.", {"middle", "#6b7280", 14});
        return svg;
    }
    for (std::size_t i = 0; i < totals.size(); ++i) {
        const std::string& name = totals[i].method;
        svg.text(kGutter - 14,
                 kTop + kRowHeight * static_cast<double>(i) + 18,
                 name.size() <= 15 ? name : name.substr(0, 14) + "~",
                 {"end", harness::is_baseline(name) ? "#6b7280" : "#20242a"});
    }
    const double width = (kWidth - kGutter - kPanelGap) / 2;
    double x = kGutter;
    for (const Side& side : sides()) {
        draw_side(svg, {x, kTop, width, kRowHeight * rows}, side, totals);
        x += width + kPanelGap;
    }
    return svg;
}

}  // namespace ink::report
