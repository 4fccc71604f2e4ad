#include "lab/page_statistics.h"

#include <fmt/format.h>

#include "lab/html.h"
#include "lab/leads.h"
#include "lab/statistics.h"
#include "lab/verdict.h"

namespace ink::lab {
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
    return fmt::format("<th scope=\"col\">{}</th>", escape(text));
}

std::string definitions_html() {
    std::string list;
    for (const auto& [term, meaning] : definitions())
        list += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", escape(term), escape(meaning));
    return fmt::format("<dl class=\"terms\">{}</dl>", list);
}

std::string lead_cell(const std::vector<Lead>& leads, const std::string& a, const std::string& b) {
    for (const Lead& lead : leads) {
        if (lead.a != a || lead.b != b) continue;
        const std::string text = escape(format_lead(lead));
        const auto space = text.find(' ');
        const std::string range =
            space == std::string::npos
                ? ""
                : fmt::format("<span class=\"range\">{}</span>", text.substr(space + 1));
        const std::string value = text.substr(0, space);
        return fmt::format(
            "<td>{} {}</td>", lead.is_beyond_chance() ? "<b>" + value + "</b>" : value, range);
    }
    return "<td></td>";
}

std::string front_line(const MethodSweep& sweep, std::size_t index, bool is_first) {
    const SettingSummary& s = sweep.settings[index];
    return fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td>{}</td><td>{}</td></tr>\n",
        is_first ? escape(sweep.method) : "",
        s.is_default() ? "as it comes" : fmt::format("<code>{}</code>", escape(s.difference)),
        format_ms(s.draw_ms),
        format_share(1 - s.error));
}

}  // namespace

std::string statistics_html(const std::vector<MethodSummary>& summaries) {
    std::vector<TextColumn> columns = statistics_columns(summaries);
    if (columns.empty()) return "";
    columns.insert(columns.begin(), name_column());
    const Cells cells = cells_of(columns, summaries);
    std::string head;
    for (const std::string& text : cells.front())
        head += heading(text);
    std::string body;
    for (std::size_t i = 0; i < summaries.size(); ++i) {
        body += fmt::format("<tr class=\"{}\"><th scope=\"row\">{}</th>",
                            summaries[i].is_bracket ? "bracket" : "",
                            escape(summaries[i].method));
        for (std::size_t column = 1; column < columns.size(); ++column)
            body += fmt::format("<td>{}</td>", escape(cells[i + 1][column]));
        body += "</tr>\n";
    }
    return table("statistics", head, body) + definitions_html();
}

std::string leads_html(const std::vector<Row>& rows) {
    const std::vector<Lead> leads = all_leads(rows);
    const Cells cells = lead_cells(leads);
    if (cells.empty()) return "";
    std::string head;
    for (const std::string& text : cells.front())
        head += heading(text);
    std::string body;
    for (std::size_t i = 1; i < cells.size(); ++i) {
        body += fmt::format("<tr><th scope=\"row\">{}</th>", escape(cells[i].front()));
        for (std::size_t j = 1; j < cells.front().size(); ++j)
            body += lead_cell(leads, cells[i].front(), cells.front()[j]);
        body += "</tr>\n";
    }
    return table(cells.front().size() > kMany ? "leads many" : "leads", head, body);
}

std::string fronts_html(const Fronts& fronts) {
    if (!fronts.is_swept) return "";
    std::string body;
    for (const MethodSweep& sweep : fronts.methods) {
        for (const std::size_t index : sweep.front)
            body += front_line(sweep, index, index == sweep.front.front());
    }
    return table("wide fronts",
                 "<th scope=\"col\">method</th><td class=\"text\">setting on its front</td>"
                 "<th scope=\"col\">draw ms</th><th scope=\"col\">F 2px</th>",
                 body);
}

}  // namespace ink::lab
