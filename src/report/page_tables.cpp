#include "report/page_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "core/escape.h"
#include "core/text_table.h"
#include "report/verdict.h"

namespace ink::report {
namespace {

/// Red as the error grows: white at F = 1, full from F = .4 down.
std::string heat_style(double f) {
    const double t = std::clamp((1 - f) / 0.6, 0.0, 1.0);
    const auto mix = [t](double from, double to) {
        return static_cast<int>(from + (to - from) * t + 0.5);
    };
    return fmt::format("background:rgb({},{},{})", mix(255, 232), mix(255, 138), mix(255, 84));
}

std::string_view split_words(const std::string& split) {
    return split == "train" ? "training" : "held-out";
}

std::string scene_heading(const std::vector<std::string>& pictured, const harness::Row& first) {
    const std::string name = core::escape(first.scene);
    const std::string anchor = scene_anchor(pictured, first.scene);
    const std::string link =
        anchor.empty() ? name : fmt::format("<a href=\"#{}\">{}</a>", anchor, name);
    return fmt::format("<th scope=\"row\" title=\"{}\">{}</th><td class=\"name\">{}</td>",
                       name,
                       link,
                       split_words(first.split));
}

std::string heat_line(const std::vector<const harness::Row*>& of_scene,
                      const std::vector<std::string>& methods) {
    std::vector<std::optional<double>> values;
    std::optional<double> best;
    for (const std::string& method : methods) {
        std::vector<const harness::Row*> of_cell;
        for (const harness::Row* row : of_scene) {
            if (row->method == method) of_cell.push_back(row);
        }
        values.push_back(experiment::pooled_f(of_cell));
        if (!harness::is_baseline(method)) best = std::max(best, values.back());
    }
    std::string line;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!values[i]) {
            line += "<td>-</td>";
            continue;
        }
        const bool is_best = !harness::is_baseline(methods[i]) && values[i] == best;
        line += fmt::format(R"(<td style="{}">{}{}{}</td>)",
                            heat_style(*values[i]),
                            is_best ? "<b>" : "",
                            core::format_share(values[i]),
                            is_best ? "</b>" : "");
    }
    return line;
}

/// A column of the table of all rows.
struct RowColumn {
    std::string heading;
    bool is_text = false;
    std::function<std::string(const harness::Row&)> cell;  ///< plain text
};

RowColumn share_of_row(std::string heading, std::optional<double> harness::Row::*field) {
    return {std::move(heading), false, [field](const harness::Row& row) {
                return core::format_share(row.*field);
            }};
}

std::vector<RowColumn> row_page_columns() {
    return {
        {"method", true, [](const harness::Row& row) { return row.method; }},
        {"scene", true, [](const harness::Row& row) { return row.scene; }},
        {"view", true, [](const harness::Row& row) { return row.view; }},
        {"split",
         true,
         [](const harness::Row& row) { return std::string(split_words(row.split)); }},
        {"size px",
         true,
         [](const harness::Row& row) { return fmt::format("{} × {}", row.width, row.height); }},
        share_of_row("F 2px", &harness::Row::f_2px),
        share_of_row("F 1px", &harness::Row::f_1px),
        share_of_row("prec.", &harness::Row::precision_2px),
        share_of_row("recall", &harness::Row::recall_2px),
        share_of_row("AP", &harness::Row::ap),
        {"width px",
         false,
         [](const harness::Row& row) {
             return row.mean_width_px ? fmt::format("{:.2f}", *row.mean_width_px) : "-";
         }},
        {"draw ms",
         false,
         [](const harness::Row& row) {
             return row.draw_ns ? format_ms(static_cast<double>(*row.draw_ns) * 1e-6) : "-";
         }},
        {"truth px",
         false,
         [](const harness::Row& row) {
             return row.is_ok() ? fmt::format("{}", row.truth_px) : "-";
         }},
        {"false negatives",
         false,
         [](const harness::Row& row) {
             return row.is_ok() ? fmt::format("{}", row.false_negatives) : "-";
         }},
        {"false positives",
         false,
         [](const harness::Row& row) {
             return row.is_ok() ? fmt::format("{}", row.false_positives) : "-";
         }},
        {"status", true, [](const harness::Row& row) { return row.status; }},
        {"parameters", true, [](const harness::Row& row) { return row.params; }},
    };
}

}  // namespace

std::vector<std::string> scenes_of(const std::vector<harness::Row>& rows) {
    std::vector<std::string> scenes;
    for (const harness::Row& row : rows) {
        if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) {
            scenes.push_back(row.scene);
        }
    }
    return scenes;
}

std::string scene_anchor(const std::vector<std::string>& pictured_scenes,
                         const std::string& scene) {
    const auto found = std::find(pictured_scenes.begin(), pictured_scenes.end(), scene);
    if (found == pictured_scenes.end()) return "";
    return fmt::format("scene-{}", found - pictured_scenes.begin() + 1);
}

std::string scene_heat_html(const std::vector<harness::Row>& rows,
                            const std::vector<experiment::MethodSummary>& summaries,
                            const std::vector<std::string>& pictured_scenes) {
    std::vector<std::string> methods;
    std::string head = "<th scope=\"col\">scene</th><td></td>";
    for (const experiment::MethodSummary& s : summaries) {
        if (s.is_baseline && s.method != "sampled") continue;
        methods.push_back(s.method);
        head += fmt::format("<th scope=\"col\">{}</th>", core::escape(s.method));
    }
    std::string body;
    for (const std::string& scene : scenes_of(rows)) {
        std::vector<const harness::Row*> of_scene;
        for (const harness::Row& row : rows) {
            if (row.scene == scene) of_scene.push_back(&row);
        }
        body += fmt::format("<tr>{}{}</tr>\n",
                            scene_heading(pictured_scenes, *of_scene.front()),
                            heat_line(of_scene, methods));
    }
    return fmt::format(
        "<div class=\"scroll\"><table class=\"heat{}\"><thead><tr>{}</tr></thead>"
        "<tbody>{}</tbody></table></div>",
        methods.size() > 8 ? " many" : "",
        head,
        body);
}

std::string failures_html(const std::vector<harness::Row>& rows) {
    std::string body;
    for (const harness::Row& row : rows) {
        if (row.is_ok()) continue;
        body += fmt::format(
            "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td>"
            "<td class=\"text\">{}</td><td class=\"text\">{}</td></tr>\n",
            core::escape(row.method),
            core::escape(row.scene),
            core::escape(row.view),
            core::escape(row.status));
    }
    if (body.empty()) return "";
    return fmt::format(
        "<div class=\"scroll\"><table class=\"wide\"><thead><tr>"
        "<th scope=\"col\">method</th><td class=\"text\">scene</td>"
        "<td class=\"text\">view</td><td class=\"text\">what went wrong</td></tr>"
        "</thead><tbody>{}</tbody></table></div>",
        body);
}

std::string rows_html(const std::vector<harness::Row>& rows) {
    const std::vector<RowColumn> columns = row_page_columns();
    std::string head;
    for (const RowColumn& column : columns) {
        head += fmt::format(R"(<th scope="col"{}><button type="button">{}</button></th>)",
                            column.is_text ? " class=\"text\"" : "",
                            column.heading);
    }
    std::string body;
    for (const harness::Row& row : rows) {
        body += "<tr>";
        for (const RowColumn& column : columns) {
            body += fmt::format("<td{}>{}</td>",
                                column.is_text ? " class=\"text\"" : "",
                                core::escape(column.cell(row)));
        }
        body += "</tr>\n";
    }
    return fmt::format(
        "<div class=\"rows\" tabindex=\"0\"><table><thead><tr>{}</tr></thead>"
        "<tbody>{}</tbody></table></div>",
        head,
        body);
}

}  // namespace ink::report
