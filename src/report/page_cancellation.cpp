#include "report/page_cancellation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/escape.h"
#include "report/cancellation_chart.h"

namespace ink::report {
namespace {

constexpr double kTwoPoints = 0.02;

double difference(const linear_code::CancellationTotal& total) {
    return total.count.predicted_rate() - total.count.measured_rate();
}

std::string kind_words(const linear_code::LineKind& kind) {
    std::string words(truth::name(kind.line_class));
    if (kind.dihedral_low_deg) {
        words += fmt::format(" of {} to {}°",
                             *kind.dihedral_low_deg,
                             *kind.dihedral_low_deg + linear_code::kDihedralBin_deg);
    }
    return words;
}

std::string few_words(int few) {
    if (few == 0) return "";
    return fmt::format(
        " {} of fewer than {} px {} left out of this and of the chart, not of the table.",
        few == 1 ? "One pair" : fmt::format("{} pairs", few),
        kFewPixels,
        few == 1 ? "is" : "are");
}

/// How well the prediction holds, over every kind that has enough pixels.
std::string worst_words(const std::vector<linear_code::CancellationRow>& rows) {
    const std::vector<linear_code::CancellationTotal> totals =
        linear_code::cancellation_by_kind(rows);
    const linear_code::CancellationTotal* worst = nullptr;
    int kinds = 0, close = 0, few = 0;
    for (const linear_code::CancellationTotal& total : totals) {
        if (total.count.n_truth < kFewPixels) {
            ++few;
            continue;
        }
        ++kinds;
        close += std::abs(difference(total)) <= kTwoPoints ? 1 : 0;
        if (worst == nullptr || std::abs(difference(total)) > std::abs(difference(*worst)))
            worst = &total;
    }
    if (worst == nullptr)
        return fmt::format("No kind of line has {} true pixels here.", kFewPixels);
    return fmt::format(
        "{} of {} pairs of method and kind of line (class and ten degrees of dihedral) agree "
        "within two points. Furthest off is {} and {}: {:.1f} % predicted, {:.1f} % measured of {} "
        "px. Only ink along true lines is predicted; what a code draws besides, between the facets "
        "of round things, may lie in a missed line's reach and be matched to it, or run together "
        "with a seen one and be thinned away with it.{}",
        close,
        kinds,
        core::escape(worst->method),
        kind_words(worst->kind),
        100 * worst->count.predicted_rate(),
        100 * worst->count.measured_rate(),
        worst->count.n_truth,
        few_words(few));
}

std::string heading(std::string_view text) {
    return fmt::format("<th scope=\"col\">{}</th>", text);
}

std::string class_table(const std::vector<linear_code::CancellationRow>& rows) {
    std::string body;
    std::string last;
    for (const linear_code::CancellationTotal& total : linear_code::cancellation_by_class(rows)) {
        const linear_code::CancellationCount& n = total.count;
        body += fmt::format(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{:.2f} %</td><td>{:.2f} %</td>"
            "<td>{:+.2f}</td><td>{:.2f} %</td></tr>\n",
            total.method == last ? "" : core::escape(total.method),
            truth::name(total.kind.line_class),
            n.n_truth,
            100 * n.predicted_rate(),
            100 * n.measured_rate(),
            100 * difference(total),
            100 * n.agreement());
        last = total.method;
    }
    return fmt::format(
        "<div class=\"scroll\"><table class=\"cause-table\"><thead><tr><th scope=\"col\">method"
        "</th>{}{}{}{}{}{}</tr></thead><tbody>{}</tbody></table></div>\n",
        heading("class"),
        heading("true px"),
        heading("missed, predicted"),
        heading("missed, measured"),
        heading("difference, points"),
        heading("pixels predicted rightly"),
        body);
}

}  // namespace

std::string_view cancellation_intro() {
    return "A sum is blind where its channels cancel: a crease whose change of normal is at right "
           "angles to the weights leaves no trace in the code. What a declared code must miss is "
           "predicted here from the truth's geometry and the weights alone, never from the "
           "method's "
           "picture: each pixel centre's depth and normal are summed, rounded and filtered where a "
           "stencil sees a true line, and the ink is thinned and matched as a picture's is. Where "
           "both agree, a miss is the code's, not the rasterizer's, and only other weights, "
           "another "
           "threshold or a second sum can mend it. Each kind has a matching of its own.";
}

std::string cancellation_html(const std::vector<linear_code::CancellationRow>& rows) {
    if (rows.empty()) return "";
    return fmt::format(
        "<div class=\"scroll chart\">{}</div><p class=\"note\">{}</p><p class=\"soft\">Dotted: of "
        "creases that lie in all directions alike, a sum with this threshold must miss sin(s/2) / "
        "sin(dihedral/2), with s the largest dihedral deviation that it keeps silent in every "
        "direction. Creases "
        "that are seen do not lie so: both their faces look at the eye, and solids stand upright, "
        "so a code may do better or worse than that. What is predicted rightly of single pixels is "
        "whether any ink comes within 2 px. The counts are in <code>cancellation.csv</code>.</p>{}",
        cancellation_chart(rows).inline_element(
            "Predicted against measured miss rates per method, class and dihedral"),
        worst_words(rows),
        class_table(rows));
}

}  // namespace ink::report
