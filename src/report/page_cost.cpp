#include "report/page_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/escape.h"
#include "experiment/summary/scaling_steps.h"
#include "report/scaling_chart.h"
#include "report/verdict.h"
#include "statistics/spread.h"

namespace ink::report {
namespace {

/// All rows of one method that declare a cost.
struct MethodCost {
    std::string method;
    method::Cost declared;
    std::vector<double> measured_ms;
    std::vector<double> predicted_ms;
    std::vector<double> residuals;
};

std::vector<MethodCost> costs_of(const std::vector<harness::Row>& rows) {
    std::vector<MethodCost> methods;
    for (const harness::Row& row : rows) {
        if (!row.cost || !row.cost->declared.is_declared()) continue;
        auto at = std::find_if(methods.begin(), methods.end(), [&](const MethodCost& m) {
            return m.method == row.method;
        });
        if (at == methods.end()) {
            methods.push_back({row.method, row.cost->declared, {}, {}, {}});
            at = methods.end() - 1;
        }
        if (row.draw_ns_min) {
            at->measured_ms.push_back(static_cast<double>(*row.draw_ns_min) * 1e-6);
        }
        if (row.predicted_ns) {
            at->predicted_ms.push_back(static_cast<double>(*row.predicted_ns) * 1e-6);
        }
        if (row.cost_residual) at->residuals.push_back(*row.cost_residual);
    }
    return methods;
}

std::string percent(const std::optional<double>& share) {
    if (!share) return "-";
    // Never a signed zero.
    const double shown = std::abs(*share) < 0.0005 ? 0 : 100 * *share;
    return fmt::format("{:+.1f} %", shown);
}

std::string spread(const std::vector<double>& residuals) {
    if (residuals.empty()) return "-";
    return fmt::format("{} to {}",
                       percent(statistics::quantile(residuals, 0.25)),
                       percent(statistics::quantile(residuals, 0.75)));
}

std::string cost_line(const MethodCost& m) {
    const method::Cost& c = m.declared;
    return fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"group\">{}</td><td>{}</td><td>{}</td>"
        "<td class=\"group\">{:g}</td><td>{:g}</td><td class=\"group\">{:g}</td><td>{:g}</td>"
        "<td class=\"group\">{}</td><td>{}</td><td class=\"group\">{}</td>"
        "<td class=\"range\">{}</td></tr>\n",
        core::escape(m.method),
        c.passes,
        c.values_per_vertex,
        c.interpolants,
        c.fill.bytes_read + c.fill.bytes_written,
        c.fill.operations,
        c.buffer_bytes_per_px + c.filter.bytes_read + c.filter.bytes_written,
        c.filter.operations,
        format_ms(statistics::quantile(m.measured_ms, 0.5)),
        format_ms(statistics::quantile(m.predicted_ms, 0.5)),
        percent(statistics::quantile(m.residuals, 0.5)),
        spread(m.residuals));
}

std::string cost_table(const std::vector<MethodCost>& methods) {
    std::string body;
    for (const MethodCost& m : methods)
        body += cost_line(m);
    return fmt::format(
        "<div class=\"scroll\"><table><thead><tr class=\"groups\"><td></td>"
        "<th scope=\"colgroup\" colspan=\"3\" class=\"group\">geometry</th>"
        "<th scope=\"colgroup\" colspan=\"2\" class=\"group\">per covered pixel</th>"
        "<th scope=\"colgroup\" colspan=\"2\" class=\"group\">per pixel</th>"
        "<th scope=\"colgroup\" colspan=\"2\" class=\"group\">least draw ms</th>"
        "<th scope=\"colgroup\" colspan=\"2\" class=\"group\">residual</th></tr>"
        "<tr><th scope=\"col\">method</th><th scope=\"col\" class=\"group\">passes</th>"
        "<th scope=\"col\">values<br>a vertex</th><th scope=\"col\">interpolants<br>a triangle</th>"
        "<th scope=\"col\" class=\"group\">bytes</th><th scope=\"col\">operations</th>"
        "<th scope=\"col\" class=\"group\">bytes</th><th scope=\"col\">operations</th>"
        "<th scope=\"col\" class=\"group\">measured</th><th scope=\"col\">predicted</th>"
        "<th scope=\"col\" class=\"group\">median</th><th scope=\"col\">quartiles</th></tr></thead>"
        "<tbody>{}</tbody></table></div>\n",
        body);
}

std::string prices_html(const experiment::CostFit& fit) {
    if (fit.cells == 0) {
        return "<p class=\"note\">Too few cells to fit the prices and to hold any of them out: "
               "nothing is predicted.</p>";
    }
    std::string body;
    for (std::size_t i = 0; i < experiment::kCostUnits; ++i) {
        body += fmt::format(
            "<tr><th scope=\"row\">{}</th><td>{:.3g}</td><td class=\"text\">{}</td></tr>\n",
            core::escape(experiment::cost_units()[i].name),
            fit.ns_per_unit[i],
            core::escape(experiment::cost_units()[i].doc));
    }
    return fmt::format(
        "<p>One price per kind of work, the same for all methods, fitted to {} cells of this run, "
        "sweeps included, by least squares of the relative error with no price below 0. Each row "
        "is predicted from a fit that left out all cells of its {}, so the residual (least "
        "measured "
        "time over predicted, less 1) is out of sample. Medians over views. A price of 0 says that "
        "the others explain these "
        "times as well, not that the work is free.</p>"
        "<div class=\"scroll\"><table><thead><tr><th scope=\"col\">one</th>"
        "<th scope=\"col\">ns</th><td class=\"text\">is</td></tr></thead><tbody>{}</tbody></table>"
        "</div>\n",
        fit.cells,
        fit.left_out,
        body);
}

/// Exponents of one axis: a line per method, a column per step.
std::string exponents_table(studies::ScalingAxis axis,
                            const std::vector<experiment::ScalingStep>& steps) {
    std::vector<std::string> methods;
    std::vector<std::pair<double, double>> stretches;
    for (const experiment::ScalingStep& step : steps) {
        if (step.axis != axis) continue;
        if (std::find(methods.begin(), methods.end(), step.method) == methods.end())
            methods.push_back(step.method);
        const std::pair stretch(step.from, step.to);
        if (std::find(stretches.begin(), stretches.end(), stretch) == stretches.end())
            stretches.push_back(stretch);
    }
    if (methods.empty()) return "";
    std::string head = "<th scope=\"col\">exponent</th>";
    for (const auto& [from, to] : stretches) {
        head += fmt::format("<th scope=\"col\">{}<br>to {}</th>",
                            experiment::format_scaling_x(axis, from),
                            experiment::format_scaling_x(axis, to));
    }
    std::string body;
    for (const std::string& method : methods) {
        body += fmt::format("<tr><th scope=\"row\">{}</th>", core::escape(method));
        for (const auto& [from, to] : stretches) {
            const auto found =
                std::find_if(steps.begin(), steps.end(), [&](const experiment::ScalingStep& s) {
                    return s.axis == axis && s.method == method && s.from == from && s.to == to;
                });
            if (found == steps.end()) {
                body += "<td>-</td>";
                continue;
            }
            const std::string text = fmt::format("{:.2f}", found->exponent);
            body += fmt::format("<td>{}</td>",
                                found->is_worse_than_linear() ? "<b>" + text + "</b>" : text);
        }
        body += "</tr>\n";
    }
    return fmt::format(
        "<div class=\"scroll\"><table><thead><tr>{}</tr></thead><tbody>{}</tbody></table></div>\n",
        head,
        body);
}

/// What is kept on an axis while the other grows.
std::string what_is_kept(const studies::ScalingPoint& point) {
    switch (point.axis) {
        case studies::ScalingAxis::triangles:
            return fmt::format("A sphere that covers {:g} % of {} x {} px.",
                               100 * point.covered_share,
                               point.width_px,
                               point.height_px);
        case studies::ScalingAxis::pixels:
            return fmt::format("A sphere of {} triangles that covers {:g} %.",
                               experiment::format_scaling_x(studies::ScalingAxis::triangles,
                                                            static_cast<double>(point.triangles)),
                               100 * point.covered_share);
        case studies::ScalingAxis::covered:
            return fmt::format(
                "A sphere of {} triangles at {} x {} px, from afar to so near that "
                "it fills the frame.",
                experiment::format_scaling_x(studies::ScalingAxis::triangles,
                                             static_cast<double>(point.triangles)),
                point.width_px,
                point.height_px);
    }
    return "";
}

}  // namespace

std::string cost_html(const ReportData& data) {
    const std::vector<MethodCost> methods = costs_of(data.rows);
    if (methods.empty()) return scaling_html(data);
    return cost_table(methods) + prices_html(data.cost_fit) + scaling_html(data);
}

std::string_view cost_intro() {
    return "What each method declares of a frame, counted from its formulas (its page says how), "
           "beside what it took. Bytes are read, written and cleared ones; a division counts as "
           "eight operations.";
}

std::string scaling_html(const ReportData& data) {
    if (data.scaling.empty()) return "";
    const std::vector<experiment::ScalingStep> steps = experiment::scaling_steps(data.scaling);
    std::string html = fmt::format(
        "<p><strong>{}</strong></p><p class=\"note\">An exponent of 1 is linear. Least times are "
        "taken to repeat within {:g} %, or as well as those of three rounds did where that is "
        "worse; a step is worse than linear (bold) if its exponent exceeds 1 by more than that "
        "alone could do.</p>\n",
        core::escape(experiment::scaling_sentence(steps)),
        100 * studies::kTimeNoise);
    for (const studies::ScalingAxisInfo& axis : studies::scaling_axes()) {
        const auto first = std::find_if(
            data.scaling.begin(), data.scaling.end(), [&](const studies::ScalingPoint& p) {
                return p.axis == axis.axis;
            });
        if (first == data.scaling.end()) continue;
        html += fmt::format(
            "<h3 style=\"margin-top:28px\">Against {}</h3><p class=\"soft\">{}</p>"
            "<div class=\"scroll chart\">{}</div>\n",
            core::escape(axis.title),
            core::escape(what_is_kept(*first)),
            scaling_chart(axis.axis, data.scaling)
                .inline_element(fmt::format("Time of a frame against {}", axis.title)));
        html += exponents_table(axis.axis, steps);
    }
    return html;
}

}  // namespace ink::report
