#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/text_table.h"
#include "draw/palette.h"
#include "experiment/summary/class_recalls.h"
#include "report/charts.h"
#include "report/verdict.h"
#include "truth/line_class.h"

namespace ink::report {
namespace {

constexpr double kWidth = 1000;
constexpr double kGutter = 166;  // method names
constexpr double kPanelGap = 26;
constexpr double kTop = 40;  // panel headings
constexpr double kRowHeight = 27;
constexpr double kBarHeight = 15;
constexpr double kValueWidth = 42;  // room for a value beside the longest bar
constexpr std::string_view kTrack = R"(fill="#eff0f2")";

using Summaries = std::vector<const experiment::MethodSummary*>;

/// A method's 95 % interval per class.
using Ranges = std::map<std::string, statistics::Interval>;

/// Methods, then the ceiling; floor and truth itself say nothing here.
Summaries shown_in_chart(const std::vector<experiment::MethodSummary>& summaries) {
    Summaries shown;
    for (const experiment::MethodSummary& s : summaries) {
        if (!s.is_baseline || s.method == "sampled") shown.push_back(&s);
    }
    return shown;
}

std::string clipped(const std::string& name, std::size_t longest) {
    return name.size() <= longest ? name : name.substr(0, longest - 1) + "~";
}

constexpr std::string_view kAbsence = "none on these views";  ///< what an empty panel says

/// A line from end to end of the interval, with its ends marked; `y` is the bar's middle.
void draw_range(Svg& svg, double left, double full, double y, const statistics::Interval& range) {
    constexpr std::string_view kStroke = R"(stroke="#20242a" stroke-width="1.1")";
    const double low = left + full * range.low;
    const double high = left + full * range.high;
    // A white rim, so that it is seen on a dark bar.
    svg.rect({low - 1.3, y - 4, high - low + 2.6, 8}, R"(fill="#ffffff" opacity="0.75")");
    svg.line(low, y, high, y, kStroke);
    svg.line(low, y - 3, low, y + 3, kStroke);
    svg.line(high, y - 3, high, y + 3, kStroke);
}

/// 0 and 1 below the bars, and what they are.
void draw_recall_axis(Svg& svg, const Box& panel, double full) {
    constexpr TextStyle kStyle = {"middle", "#6b7280", 11.5};
    const double y = panel.y + panel.height - 5;
    svg.text(panel.x + 3, y, "0", kStyle);
    svg.text(panel.x + full / 2, y, "recall at 2 px", kStyle);
    svg.text(panel.x + full - 3, y, "1", kStyle);
}

void draw_panel(Svg& svg,
                const Box& panel,
                truth::LineClass c,
                const Summaries& shown,
                const std::vector<Ranges>& ranges) {
    const std::string name(truth::name(c));
    const std::string fill = fmt::format("fill=\"{}\"", draw::colour_of(c).hex);
    svg.rect({panel.x, 12, 11, 11}, fill + R"( rx="2")");
    svg.text(panel.x + 17, 22, name, {.is_bold = true});
    const bool is_there =
        std::any_of(shown.begin(), shown.end(), [&](const experiment::MethodSummary* s) {
            return s->recall_by_class.count(name) != 0;
        });
    if (!is_there) {
        svg.text(panel.x, panel.y + 18, kAbsence, {.fill = "#6b7280"});
        return;
    }
    const double full = panel.width - kValueWidth;
    draw_recall_axis(svg, panel, full);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const double y = panel.y + kRowHeight * static_cast<double>(i);
        svg.rect({panel.x, y + 5, full, kBarHeight}, kTrack);
        const auto found = shown[i]->recall_by_class.find(name);
        if (found == shown[i]->recall_by_class.end()) continue;
        const double length = full * found->second;
        const char* faint = shown[i]->is_baseline ? R"( opacity="0.45")" : "";
        svg.rect({panel.x, y + 5, length, kBarHeight}, fill + faint);
        const auto range = ranges[i].find(name);
        if (range != ranges[i].end())
            draw_range(svg, panel.x, full, y + 5 + kBarHeight / 2, range->second);
        svg.text(panel.x + full + 5, y + 17, core::format_share(found->second), {.size = 12});
    }
}

}  // namespace

Svg class_chart(const std::vector<experiment::MethodSummary>& summaries,
                const std::vector<harness::Row>& rows) {
    const Summaries shown = shown_in_chart(summaries);
    std::vector<Ranges> ranges;
    for (const experiment::MethodSummary* s : shown)
        ranges.push_back(
            experiment::class_recall_intervals(experiment::rows_of_method(rows, s->method)));
    const double lines = std::max<double>(1, static_cast<double>(shown.size()));
    const double height = kTop + kRowHeight * lines + 22;
    Svg svg(kWidth, height);
    if (shown.empty()) {
        svg.text(kWidth / 2, height / 2, "No method was scored.", {"middle", "#6b7280", 14});
        return svg;
    }
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const double y = kTop + kRowHeight * static_cast<double>(i) + 17;
        svg.text(kGutter - 14,
                 y,
                 clipped(shown[i]->method, 20),
                 {"end", shown[i]->is_baseline ? "#6b7280" : "#20242a"});
    }
    const auto count = static_cast<double>(truth::kLineClasses.size());
    const double width = (kWidth - kGutter - kPanelGap * (count - 1)) / count;
    double x = kGutter;
    for (const truth::LineClass c : truth::kLineClasses) {
        draw_panel(svg, {x, kTop, width, height - kTop}, c, shown, ranges);
        x += width + kPanelGap;
    }
    return svg;
}

}  // namespace ink::report
