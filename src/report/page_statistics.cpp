#include "report/page_statistics.h"

#include <fmt/format.h>

#include "core/escape.h"
#include "core/text_table.h"
#include "experiment/summary/paired_differences.h"
#include "report/statistics.h"
#include "report/verdict.h"

namespace ink::report {
namespace {

constexpr std::size_t kMany = 9;  // columns; with more, headings stand upright and cells are narrow

std::string table(std::string_view classes, const std::string& head, const std::string& body) {
    return fmt::format(
        "<div class=\"scroll\"><table class=\"{}\"><thead><tr>{}</tr></thead><tbody>{}</tbody>"
        "</table></div>",
        classes,
        head,
        body);
}

std::string heading(const std::string& text) {
    return fmt::format("<th scope=\"col\">{}</th>", core::escape(text));
}

std::string definitions_html() {
    std::string list;
    for (const auto& [term, meaning] : definitions())
        list += fmt::format(
            "<div><dt>{}</dt><dd>{}</dd></div>", core::escape(term), core::escape(meaning));
    return fmt::format("<dl class=\"terms\">{}</dl>", list);
}

std::string paired_difference_cell(const std::vector<experiment::PairedDifference>& differences,
                                   const std::string& a,
                                   const std::string& b) {
    for (const experiment::PairedDifference& paired : differences) {
        if (paired.a != a || paired.b != b) continue;
        const std::string text = core::escape(experiment::format_paired_difference(paired));
        const auto space = text.find(' ');
        const std::string range =
            space == std::string::npos
                ? ""
                : fmt::format("<span class=\"range\">{}</span>", text.substr(space + 1));
        const std::string value = text.substr(0, space);
        return fmt::format(
            "<td>{} {}</td>", paired.is_significant() ? "<b>" + value + "</b>" : value, range);
    }
    return "<td></td>";
}

std::string front_line(const experiment::MethodSweep& sweep, std::size_t index, bool is_first) {
    const experiment::SettingSummary& s = sweep.settings[index];
    return fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td>{}</td><td>{}</td></tr>\n",
        is_first ? core::escape(sweep.method) : "",
        s.is_default() ? "as it comes" : fmt::format("<code>{}</code>", core::escape(s.difference)),
        format_ms(s.draw_ms),
        core::format_share(1 - s.error));
}

}  // namespace

std::string statistics_html(const std::vector<experiment::MethodSummary>& summaries) {
    std::vector<TextColumn> columns = statistics_columns(summaries);
    if (columns.empty()) return "";
    columns.insert(columns.begin(), name_column());
    const core::Cells cells = cells_of(columns, summaries);
    std::string head;
    for (const std::string& text : cells.front())
        head += heading(text);
    std::string body;
    for (std::size_t i = 0; i < summaries.size(); ++i) {
        body += fmt::format("<tr class=\"{}\"><th scope=\"row\">{}</th>",
                            summaries[i].is_baseline ? "baseline" : "",
                            core::escape(summaries[i].method));
        for (std::size_t column = 1; column < columns.size(); ++column)
            body += fmt::format("<td>{}</td>", core::escape(cells[i + 1][column]));
        body += "</tr>\n";
    }
    return table("statistics", head, body) + definitions_html();
}

std::string paired_differences_html(const std::vector<harness::Row>& rows) {
    const std::vector<experiment::PairedDifference> differences =
        experiment::all_paired_differences(rows);
    const core::Cells cells = paired_difference_cells(differences);
    if (cells.empty()) return "";
    std::string head;
    for (const std::string& text : cells.front())
        head += heading(text);
    std::string body;
    for (std::size_t i = 1; i < cells.size(); ++i) {
        body += fmt::format("<tr><th scope=\"row\">{}</th>", core::escape(cells[i].front()));
        for (std::size_t j = 1; j < cells.front().size(); ++j)
            body += paired_difference_cell(differences, cells[i].front(), cells.front()[j]);
        body += "</tr>\n";
    }
    return table(cells.front().size() > kMany ? "leads many" : "leads", head, body);
}

std::string fronts_html(const experiment::Fronts& fronts) {
    if (!fronts.is_swept) return "";
    std::string body;
    for (const experiment::MethodSweep& sweep : fronts.methods) {
        for (const std::size_t index : sweep.front)
            body += front_line(sweep, index, index == sweep.front.front());
    }
    return table("wide fronts",
                 "<th scope=\"col\">method</th><td class=\"text\">setting on its front</td>"
                 "<th scope=\"col\">draw ms</th><th scope=\"col\">F 2px</th>",
                 body);
}

}  // namespace ink::report
