#include "report/page_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "core/escape.h"
#include "core/text_table.h"
#include "report/page_tables.h"
#include "report/verdict.h"
#include "truth/line_class.h"

namespace ink::report {
namespace {

/// A column of the verdict table; `value` is what the best cell of the column is found by.
struct VerdictColumn {
    std::string group;    ///< heading above the heading; equal neighbours share one cell
    std::string heading;  ///< HTML
    std::function<std::string(const experiment::MethodSummary&)> cell;  ///< HTML
    std::function<std::optional<double>(const experiment::MethodSummary&)> value = nullptr;
};

VerdictColumn share_column(std::string group,
                           std::string heading,
                           std::optional<double> experiment::MethodSummary::*field) {
    return {std::move(group),
            std::move(heading),
            [field](const experiment::MethodSummary& s) { return core::format_share(s.*field); },
            [field](const experiment::MethodSummary& s) { return s.*field; }};
}

VerdictColumn recall_column(const std::string& name) {
    const auto recall = [name](const experiment::MethodSummary& s) -> std::optional<double> {
        const auto found = s.recall_by_class.find(name);
        if (found == s.recall_by_class.end()) return std::nullopt;
        return found->second;
    };
    return {"recall per class",
            name,
            [recall](const experiment::MethodSummary& s) { return core::format_share(recall(s)); },
            recall};
}

std::string range_cell(const experiment::MethodSummary& s) {
    if (!s.f_2px_range) return "-";
    return fmt::format("<span class=\"range\">{}–{}</span>",
                       core::format_share(s.f_2px_range->low),
                       core::format_share(s.f_2px_range->high));
}

std::string views_cell(const experiment::MethodSummary& s) {
    if (s.failed == 0) return fmt::format("{}", s.views);
    return fmt::format("<b>{}</b> of {}", s.views, s.views + s.failed);
}

/// What a table is of: all scenes, or the views of one.
enum class Scope { all_scenes, one_scene };

std::vector<VerdictColumn> verdict_columns(const std::vector<experiment::MethodSummary>& summaries,
                                           Scope scope) {
    const char* kF = "F at 2 px";
    std::vector<VerdictColumn> columns = {
        share_column(kF, "pooled", &experiment::MethodSummary::f_2px)};
    if (scope == Scope::all_scenes) {
        columns.push_back({kF, "95 %", range_cell});
        columns.push_back(share_column(kF, "training", &experiment::MethodSummary::f_train));
        columns.push_back(share_column(kF, "held-out", &experiment::MethodSummary::f_heldout));
        columns.push_back(share_column(kF, "macro", &experiment::MethodSummary::f_macro));
        columns.push_back(share_column(kF, "median", &experiment::MethodSummary::f_median));
    }
    columns.push_back(share_column("at 1 px", "F", &experiment::MethodSummary::f_1px));
    columns.push_back(share_column("at 2 px", "prec.", &experiment::MethodSummary::precision));
    columns.push_back(share_column("at 2 px", "recall", &experiment::MethodSummary::recall));
    for (const truth::LineClass c : truth::kLineClasses) {
        const std::string name(truth::name(c));
        const bool is_there = std::any_of(summaries.begin(), summaries.end(), [&](const auto& s) {
            return s.recall_by_class.count(name) != 0;
        });
        if (is_there) columns.push_back(recall_column(name));
    }
    columns.push_back({"px", "width", [](const experiment::MethodSummary& s) {
                           return s.mean_width_px ? fmt::format("{:.2f}", *s.mean_width_px) : "-";
                       }});
    columns.push_back({"cost",
                       "draw ms",
                       [](const experiment::MethodSummary& s) { return format_ms(s.draw_ms); },
                       [](const experiment::MethodSummary& s) -> std::optional<double> {
                           if (!s.draw_ms) return std::nullopt;
                           return -*s.draw_ms;
                       }});
    columns.push_back({"cost", "B/px", [](const experiment::MethodSummary& s) {
                           return s.bytes_per_px ? fmt::format("{}", *s.bytes_per_px) : "-";
                       }});
    columns.push_back({"cells", "views", views_cell});
    return columns;
}

bool starts_group(const std::vector<VerdictColumn>& columns, std::size_t i) {
    return i == 0 || columns[i].group != columns[i - 1].group;
}

std::string verdict_head(const std::vector<VerdictColumn>& columns) {
    std::string groups = "<tr class=\"groups\"><td></td>";
    std::string headings = "<tr><th scope=\"col\">method</th>";
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const char* edge = starts_group(columns, i) ? " class=\"group\"" : "";
        headings += fmt::format("<th scope=\"col\"{}>{}</th>", edge, columns[i].heading);
        if (!starts_group(columns, i)) continue;
        std::size_t end = i + 1;
        while (end < columns.size() && !starts_group(columns, end))
            ++end;
        groups += fmt::format("<th scope=\"colgroup\" colspan=\"{}\" class=\"group\">{}</th>",
                              end - i,
                              columns[i].group);
    }
    return fmt::format("<thead>{}</tr>{}</tr></thead>", groups, headings);
}

/// The highest value of a column among methods; baselines do not compete.
std::optional<double> best_of(const VerdictColumn& column,
                              const std::vector<experiment::MethodSummary>& summaries) {
    std::optional<double> best;
    if (!column.value) return best;
    for (const experiment::MethodSummary& s : summaries) {
        if (!s.is_baseline) best = std::max(best, column.value(s));
    }
    return best;
}

std::string table_html(const std::vector<experiment::MethodSummary>& summaries, Scope scope) {
    const std::vector<VerdictColumn> columns = verdict_columns(summaries, scope);
    const experiment::Verdict verdict = experiment::find_verdict(summaries);
    std::string body;
    bool has_baseline = false;
    for (const experiment::MethodSummary& s : summaries) {
        std::string classes = &s == verdict.best ? "best" : "";
        if (s.is_baseline) classes = has_baseline ? "baseline" : "baseline first-baseline";
        has_baseline = has_baseline || s.is_baseline;
        body += fmt::format(
            R"(<tr class="{}"><th scope="row">{}</th>)", classes, core::escape(s.method));
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const std::optional<double> best = best_of(columns[i], summaries);
            const bool is_best = !s.is_baseline && best && columns[i].value(s) == best;
            body += fmt::format("<td{}>{}{}{}</td>",
                                starts_group(columns, i) ? " class=\"group\"" : "",
                                is_best ? "<b>" : "",
                                columns[i].cell(s),
                                is_best ? "</b>" : "");
        }
        body += "</tr>\n";
    }
    return fmt::format(
        "<div class=\"scroll\"><table class=\"verdict\">{}<tbody>{}</tbody></table></div>",
        verdict_head(columns),
        body);
}

}  // namespace

std::string verdict_html(const std::vector<experiment::MethodSummary>& summaries) {
    return table_html(summaries, Scope::all_scenes);
}

std::string scene_verdicts_html(const std::vector<harness::Row>& rows) {
    std::string html;
    for (const std::string& scene : scenes_of(rows)) {
        std::vector<harness::Row> of_scene;
        for (const harness::Row& row : rows) {
            if (row.scene == scene) of_scene.push_back(row);
        }
        const std::vector<experiment::MethodSummary> summaries = experiment::summarise(of_scene);
        const experiment::Verdict verdict = experiment::find_verdict(summaries);
        const std::string best = verdict.best == nullptr
                                     ? "no method was scored"
                                     : fmt::format("best: {}, F {}",
                                                   core::escape(verdict.best->method),
                                                   core::format_share(verdict.best->f_2px));
        html += fmt::format(
            "<details class=\"counts\"><summary>{} <span class=\"note\">{}</span></summary>{}"
            "</details>\n",
            core::escape(scene),
            best,
            table_html(summaries, Scope::one_scene));
    }
    return html;
}

}  // namespace ink::report
