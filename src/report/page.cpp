#include "report/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/escape.h"
#include "core/provenance.h"
#include "core/text_table.h"
#include "experiment/summary/summary.h"
#include "experiment/summary/unscored.h"
#include "report/cause_chart.h"
#include "report/charts.h"
#include "report/page_about.h"
#include "report/page_assets.h"
#include "report/page_cancellation.h"
#include "report/page_causes.h"
#include "report/page_cost.h"
#include "report/page_crosscheck.h"
#include "report/page_motion.h"
#include "report/page_place.h"
#include "report/page_scenes.h"
#include "report/page_skips.h"
#include "report/page_statistics.h"
#include "report/page_tables.h"
#include "report/page_verdict.h"
#include "report/verdict.h"

namespace ink::report {
namespace {

// The page stays under 20 MB; tables and charts take the rest.
constexpr std::size_t kImageBudget_bytes = 16'000'000;

/// What the parts of the page are made from.
struct Material {
    const ReportData& data;
    std::vector<experiment::MethodSummary> summaries;
    experiment::Verdict verdict;
    PageScenes scenes;
    std::string failures;
    std::string crosscheck = {};  ///< HTML, "" if no truth was held against it
    experiment::Fronts fronts;
    std::string differences;  ///< HTML, "" with fewer than two methods
    std::string statistics;   ///< HTML, "" if there are none
    std::string cost = {};    ///< HTML, "" if no method declares any
    std::string skips = {};   ///< HTML, "" if no row says what was skipped
    std::string motion = {};  ///< HTML, "" if no sequence was studied
};

const experiment::MethodSummary* find_summary(
    const std::vector<experiment::MethodSummary>& summaries, std::string_view method) {
    for (const experiment::MethodSummary& s : summaries) {
        if (s.method == method) return &s;
    }
    return nullptr;
}

/// What the ceiling says of the winner, and who else is worth a look.
std::string context_sentences(const Material& m) {
    std::string text;
    const experiment::MethodSummary* sampled = find_summary(m.summaries, "sampled");
    if (m.verdict.best != nullptr && sampled != nullptr && sampled->f_2px) {
        text += fmt::format(" Exact lines seen once per pixel centre would reach F {}.",
                            core::format_share(sampled->f_2px));
    }
    std::vector<experiment::CostPoint> costs;
    std::vector<const experiment::MethodSummary*> methods;
    for (const experiment::MethodSummary& s : m.summaries) {
        if (s.is_baseline || !s.f_2px || !s.draw_ms) continue;
        costs.push_back({*s.draw_ms, 1 - *s.f_2px});
        methods.push_back(&s);
    }
    std::string front;
    for (const std::size_t index : experiment::pareto_front(costs)) {
        front += (front.empty() ? "" : ", ") + methods[index]->method;
    }
    if (methods.size() > 1) {
        text += fmt::format(" No method is both faster and better than these: {}.", front);
    }
    return core::escape(text);
}

std::string fact(std::string_view name, const std::string& value, std::string_view unit = "") {
    return fmt::format("<div><dt>{}</dt><dd>{}{}</dd></div>",
                       name,
                       value,
                       unit.empty() ? "" : fmt::format(" <small>{}</small>", unit));
}

std::string facts_html(const Material& m) {
    std::set<std::string> scenes;
    std::set<std::pair<std::string, std::string>> views;
    for (const harness::Row& row : m.data.rows) {
        scenes.insert(row.scene);
        views.insert({row.scene, row.view});
    }
    int methods = 0;
    for (const experiment::MethodSummary& s : m.summaries)
        methods += s.is_baseline ? 0 : 1;
    std::string facts;
    if (const experiment::MethodSummary* best = m.verdict.best) {
        facts += fact("F at 2 px", core::format_share(best->f_2px));
        if (best->draw_ms) facts += fact("its frame", format_ms(best->draw_ms), "ms");
    }
    facts += fact("methods", std::to_string(methods));
    facts += fact("scenes", std::to_string(scenes.size()));
    facts += fact("views", std::to_string(views.size()));
    return fmt::format("<dl class=\"facts\">{}</dl>", facts);
}

std::string warning(std::string_view title, const std::string& text, const std::string& items) {
    return fmt::format(
        "<div class=\"warning\" role=\"alert\"><strong>{}</strong> {}<ul>{}</ul></div>",
        title,
        text,
        items);
}

/// What must hold of every run and did not, in the run's own words.
std::string invalid_html(const std::vector<std::string>& faults) {
    std::string items;
    for (const std::string& fault : faults)
        items += fmt::format("<li>{}</li>", core::escape(fault));
    if (items.empty()) return "";
    return warning("This run is invalid.", "What must hold of every run does not:", items);
}

/// An interrupted run says what is missing, so that nobody takes the part for the whole.
std::string missing_html(const ReportData& data) {
    if (data.missing_blocks.empty()) return "";
    constexpr std::size_t kMostNamed = 20;
    std::string items;
    for (std::size_t i = 0; i < std::min(kMostNamed, data.missing_blocks.size()); ++i)
        items += fmt::format("<li>{}</li>", core::escape(data.missing_blocks[i]));
    if (data.missing_blocks.size() > kMostNamed)
        items += fmt::format("<li>and {} more</li>", data.missing_blocks.size() - kMostNamed);
    return warning("This run is not finished.",
                   fmt::format("{} of {} parts are missing, and every number below is of the rest. "
                               "The same command goes on where it stopped. Missing:",
                               data.missing_blocks.size(),
                               data.blocks),
                   items);
}

std::string unscored_html(const std::vector<harness::Row>& rows) {
    std::string items;
    for (const experiment::Unscored& cell : experiment::unscored_cells(rows)) {
        items += fmt::format("<li><strong>{} {}</strong>{}: {}<br>Try: {}</li>",
                             core::escape(cell.scene),
                             core::escape(cell.view),
                             cell.method.empty() ? "" : ", " + core::escape(cell.method),
                             core::escape(cell.reason),
                             core::escape(cell.remedy));
    }
    if (items.empty()) return "";
    return warning("Some views have no score.", "They enter no number here:", items);
}

std::string header_html(const Material& m) {
    return fmt::format(
        "<header><div class=\"wrap\"><div class=\"brand\">{}<span><strong>Inkbench</strong> · "
        "which outline method makes the fewest errors at a time budget?</span></div><h1>{}</h1>"
        "<p class=\"lead\">{}{}</p>{}{}</div></header>\n",
        page_mark(),
        core::escape(verdict_headline(m.verdict)),
        core::escape(verdict_details(m.data.rows, m.summaries)),
        context_sentences(m),
        missing_html(m.data) + invalid_html(m.data.faults) + unscored_html(m.data.rows),
        facts_html(m));
}

std::string nav_html(const Material& m) {
    std::string links;
    const auto link = [&links](std::string_view anchor, std::string_view words) {
        links += fmt::format("<a href=\"#{}\">{}</a>", anchor, words);
    };
    link("verdict", "Verdict");
    if (!m.differences.empty()) link("leads", "Differences");
    link("time", "Error against time");
    if (!m.cost.empty()) link("cost", "Cost");
    if (!m.statistics.empty()) link("statistics", "Thresholds");
    link("classes", "Line classes");
    link("causes", "Where the error goes");
    if (!m.data.cancellation.empty()) link("cancellation", "Cancellation");
    const bool has_lines =
        std::any_of(m.data.rows.begin(), m.data.rows.end(), [](const harness::Row& row) {
            return row.lines.has_value();
        });
    if (has_lines) {
        link("place", "Place and width");
        link("bins", "By kind of place");
    }
    link("by-scene", "By scene");
    link("pictures", "Pictures");
    if (!m.motion.empty()) link("motion", "In motion");
    if (!m.skips.empty()) link("skips", "Skips");
    if (!m.crosscheck.empty()) link("crosscheck", "Cross-check");
    if (!m.failures.empty()) link("failed", "Failed cells");
    link("rows", "All rows");
    link("about", "How to read this");
    return fmt::format(
        "<nav aria-label=\"Parts of the report\"><div class=\"wrap\">{}</div></nav>\n", links);
}

std::string section(std::string_view id,
                    std::string_view title,
                    std::string_view intro,
                    const std::string& content) {
    return fmt::format("<section id=\"{}\"><h2>{}</h2>{}{}</section>\n",
                       id,
                       title,
                       intro.empty() ? "" : fmt::format("<p class=\"soft\">{}</p>", intro),
                       content);
}

std::string chart_html(const Svg& chart, std::string_view title) {
    return fmt::format("<div class=\"scroll chart\">{}</div>", chart.inline_element(title));
}

/// What the chart shows, and over which views.
std::string time_intro(const experiment::Fronts& fronts) {
    const std::string stair =
        "The grey stair is the lowest error to be had at each time; what lies above it is beaten "
        "in "
        "both.";
    if (!fronts.is_swept) return "One point per method. " + stair;
    return fmt::format(
        "Large: a method as it comes, with its 95 % interval and the quartiles of its time. Small: "
        "other settings of it; point at one to read which. Its line joins those that no other of "
        "its "
        "settings beats. {} Over "
        "{} view{} of {} scene{}, so values differ a little from the "
        "verdict's.",
        stair,
        fronts.views,
        fronts.views == 1 ? "" : "s",
        fronts.scenes,
        fronts.scenes == 1 ? "" : "s");
}

std::string causes_html(const std::vector<harness::Row>& rows) {
    const std::vector<experiment::CauseTotals> totals = experiment::cause_totals(rows);
    return chart_html(cause_chart(totals), "Missing and false pixels per method and cause") +
           cause_legend_html() + cause_table_html(totals);
}

std::string main_html(const Material& m) {
    const std::vector<harness::Row>& rows = m.data.rows;
    std::string html = section("verdict",
                               "Verdict",
                               "Best of each column in bold. Grey rows are baselines, not methods.",
                               verdict_html(m.summaries));
    if (!m.differences.empty()) {
        html +=
            section("leads",
                    "Paired differences",
                    "By how much F of a line's method exceeds that of a column's, with its 95 % "
                    "interval: scenes resampled with all their views, both methods on the same "
                    "ones. Bold: significant. Of twenty such intervals one may miss by chance.",
                    m.differences);
    }
    html += section("time",
                    "Error against time",
                    time_intro(m.fronts),
                    chart_html(front_chart(m.fronts), "Error 1 - F at 2 px against draw time") +
                        fronts_html(m.fronts));
    if (!m.cost.empty()) html += section("cost", "Cost", cost_intro(), m.cost);
    if (!m.statistics.empty()) {
        html +=
            section("statistics",
                    "Other thresholds and tolerances",
                    "What a method could reach at another threshold, how near its lines lie, and "
                    "what a random image with as many positive pixels scores.",
                    m.statistics);
    }
    html += section("classes",
                    "Recall per line class",
                    "How much of each kind of true line was found within 2 px, pooled over views.",
                    chart_html(class_chart(m.summaries, rows), "Recall per line class and method"));
    html += section("causes",
                    "Where the error goes",
                    "Each missing and each false pixel has one cause, read off the exact truth at "
                    "the pixel centres round it; pooled over views. Grey, or unmatched truth and "
                    "unmatched duplicates in "
                    "the table, is what one-to-one pairing left over beside lines that were found: "
                    "doubled, frayed or shortened ones.",
                    causes_html(rows));
    if (!m.data.cancellation.empty()) {
        html += section("cancellation",
                        "Cancellation: misses predicted",
                        cancellation_intro(),
                        cancellation_html(m.data.cancellation));
    }
    const std::string place = place_html(rows);
    if (!place.empty()) {
        html += section(
            "place",
            "Place and width",
            "What F forgives, because it thins and allows 2 px. Cracks: unthinned, a drawn pixel "
            "is "
            "right if a true line runs between it and one of its four neighbours. Offset: thinned "
            "pixels from the nearest true curve, positive to its empty side. Width: across the "
            "true "
            "curves. Far positives: unthinned pixels further than 2 px from every true one.",
            place);
        html += section("bins",
                        "Recall by kind of place",
                        "Share of the true pixels found within 2 px, each bin by a matching of its "
                        "own; the redder, the more is missed.",
                        bins_html(rows));
    }
    html += section("by-scene",
                    "F by scene",
                    "Pooled over a scene's views at 2 px; the redder, the more is wrong. The best "
                    "method of each scene in bold.",
                    scene_heat_html(rows, m.summaries, pictured_scenes(m.scenes)) +
                        "<p class=\"soft\">Each scene in full, every method:</p>" +
                        scene_verdicts_html(rows));
    html += section(
        "pictures",
        "Truth and methods, side by side",
        "One view per scene. Drag across a picture, or move the divider below it with "
        "the arrow keys: truth to the left, the method to the right.",
        scenes_html(m.scenes, rows, m.verdict.best == nullptr ? "" : m.verdict.best->method));
    if (!m.motion.empty()) html += section("motion", "In motion", motion_intro(), m.motion);
    if (!m.skips.empty()) html += section("skips", "Skips", skips_intro(), m.skips);
    if (!m.crosscheck.empty()) {
        html +=
            section("crosscheck",
                    "Truth against the cross-check",
                    "The cross-check finds the lines by dense sampling of what is seen and shares "
                    "only mesh and camera with the truth. Disagreement: the share of both "
                    "lengths, class by class, that the other lacks within 0.25 px.",
                    m.crosscheck);
    }
    if (!m.failures.empty()) {
        html += section("failed", "Failed cells", "They enter no mean and no chart.", m.failures);
    }
    html += section(
        "rows",
        "All rows",
        "The same rows, with every column, are in <code>rows.csv</code>; the curves "
        "over 99 thresholds in <code>curves.csv</code>, the tolerances in "
        "<code>tolerances.csv</code>, the settings of the sweeps, with the same columns, in "
        "<code>sweep.csv</code>. Press a heading to sort.",
        "<div class=\"tools\"><label>Filter <input type=\"search\" id=\"filter-rows\" "
        "placeholder=\"method, scene ...\"></label></div>" +
            rows_html(rows));
    html += section("about", "How to read this", "", about_html() + provenance_html(m.data));
    return html;
}

}  // namespace

std::string report_page(const ReportData& data) {
    Material material{
        data, experiment::summarise(data.rows), {}, {}, failures_html(data.rows), {}, {}, {}, {}};
    material.crosscheck = crosscheck_html(data.rows);
    material.skips = skips_html(data.rows, data.skip_study);
    material.motion = motion_html(data.motion, data.rolls);
    experiment::add_curves(data.curves, material.summaries);
    material.fronts = experiment::summarise_fronts(data.rows, data.sweep);
    material.differences = paired_differences_html(data.rows);
    material.cost = cost_html(data);
    material.statistics = statistics_html(material.summaries);
    material.verdict = experiment::find_verdict(material.summaries);
    material.scenes = encode_scenes(data.views, kImageBudget_bytes);
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>Inkbench: {}</title>\n<style>{}</style></head>\n<body>\n{}{}"
        "<main class=\"wrap\">\n{}</main>\n<footer class=\"wrap\">Made by inkbench {}. This page "
        "needs no other file and no network.</footer>\n<script>{}</script>\n</body></html>\n",
        core::escape(verdict_headline(material.verdict)),
        page_style(),
        header_html(material),
        nav_html(material),
        main_html(material),
        core::escape(core::provenance().version),
        page_script());
}

}  // namespace ink::report
