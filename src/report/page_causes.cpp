#include "report/page_causes.h"

#include <fmt/format.h>

#include <span>

#include "core/escape.h"
#include "draw/palette.h"
#include "experiment/summary/summary.h"

namespace ink::report {
namespace {

std::string swatch(score::Cause cause) {
    return fmt::format("<i style=\"background:{}\"></i>", draw::colour_of(cause).hex);
}

std::string legend_list(std::string_view heading, std::span<const score::Cause> causes) {
    std::string items = fmt::format("<li class=\"soft\">{}</li>", heading);
    for (const score::Cause cause : causes) {
        items += fmt::format("<li>{}<b>{}</b> <span class=\"soft\">{}</span></li>",
                             swatch(cause),
                             experiment::label_of(cause),
                             experiment::meaning_of(cause));
    }
    return fmt::format("<ul class=\"causes\">{}</ul>", items);
}

/// A count with its share below it; nothing but a dash where there is none.
std::string count_cell(std::int64_t count, std::int64_t whole, bool starts_group = false) {
    const char* group = starts_group ? " class=\"group\"" : "";
    if (count == 0) return fmt::format("<td{}>–</td>", group);
    const double percent =
        whole == 0 ? 0 : 100 * static_cast<double>(count) / static_cast<double>(whole);
    return fmt::format("<td{}>{}<small>{}</small></td>",
                       group,
                       count,
                       percent < 0.05 ? "&lt; 0.1 %" : fmt::format("{:.1f} %", percent));
}

/// Half a line: the whole, what is wrong of it, why, and what is contested.
struct HalfLine {
    std::int64_t whole;
    std::int64_t wrong;
    std::span<const score::Cause> causes;
    std::int64_t contested;
};

std::string half_line(const HalfLine& half, const score::CauseCounts& counts) {
    std::string cells = fmt::format("<td class=\"group\">{}</td>", half.whole);
    cells += count_cell(half.wrong, half.whole);
    for (const score::Cause cause : half.causes)
        cells += count_cell(counts[cause], half.whole);
    return cells + count_cell(half.contested, half.whole);
}

std::string half_head(std::string_view whole,
                      std::string_view wrong,
                      std::span<const score::Cause> causes,
                      std::string_view contested) {
    std::string cells = fmt::format(
        "<th scope=\"col\" class=\"group\">{}</th><th scope=\"col\">{}</th>", whole, wrong);
    for (const score::Cause cause : causes) {
        cells += fmt::format("<th scope=\"col\" title=\"{}\">{}<br>{}</th>",
                             experiment::meaning_of(cause),
                             swatch(cause),
                             experiment::label_of(cause));
    }
    return cells + fmt::format("<th scope=\"col\">{}</th>", contested);
}

}  // namespace

std::string cause_legend_html() {
    return fmt::format("<div class=\"cause-legend\">{}{}</div>",
                       legend_list("Missing lines, in warm colours", score::kFalseNegativeCauses),
                       legend_list("False lines, in cool colours", score::kFalsePositiveCauses));
}

std::string cause_table_html(const std::vector<experiment::CauseTotals>& totals) {
    if (totals.empty()) return "<p class=\"note\">No method was scored.</p>";
    std::string body;
    for (const experiment::CauseTotals& t : totals) {
        body += fmt::format(
            "<tr{}><th scope=\"row\">{}</th>{}{}</tr>\n",
            harness::is_baseline(t.method) ? " class=\"baseline\"" : "",
            core::escape(t.method),
            half_line(
                {t.n_truth, t.false_negatives, score::kFalseNegativeCauses, t.unmatched_truth},
                t.causes),
            half_line(
                {t.n_pred, t.false_positives, score::kFalsePositiveCauses, t.unmatched_duplicates},
                t.causes));
    }
    return fmt::format(
        "<div class=\"scroll\"><table class=\"cause-table\"><thead><tr class=\"groups\"><td></td>"
        "<td colspan=\"{}\" class=\"group\">true pixels: what was not found</td>"
        "<td colspan=\"{}\" class=\"group\">drawn pixels: what is on no line</td></tr>"
        "<tr><th scope=\"col\">method</th>{}{}</tr></thead><tbody>{}</tbody></table></div>",
        score::kFalseNegativeCauses.size() + 3,
        score::kFalsePositiveCauses.size() + 3,
        half_head("true", "false negatives", score::kFalseNegativeCauses, "unmatched truth"),
        half_head("drawn", "false positives", score::kFalsePositiveCauses, "unmatched duplicates"),
        body);
}

}  // namespace ink::report
