#include "report/page_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/escape.h"
#include "core/text_table.h"
#include "experiment/summary/summary.h"
#include "report/verdict.h"

namespace ink::report {
namespace {

/// The line scores of one method over all its views.
struct Pooled {
    std::string method;
    score::CrackScore cracks;
    score::Moments offsets;
    score::Moments widths;
    score::PositiveCount positives;
    std::map<std::pair<std::size_t, double>, harness::BinCount>
        bins;  ///< by attribute and lower end
};

void add(const score::Moments& from, score::Moments& into) {
    into.n += from.n;
    into.sum += from.sum;
    into.sum_of_squares += from.sum_of_squares;
}

void add(const harness::LineScores& from, Pooled& into) {
    into.cracks.n_drawn += from.cracks.n_drawn;
    into.cracks.n_beside += from.cracks.n_beside;
    into.cracks.all.n_found += from.cracks.all.n_found;
    into.cracks.all.n_truth += from.cracks.all.n_truth;
    add(from.offsets.all, into.offsets);
    add(from.widths.all, into.widths);
    into.positives.n_drawn += from.positives.n_drawn;
    into.positives.n_false += from.positives.n_false;
    for (const harness::BinCount& bin : from.bins) {
        auto [at, is_new] = into.bins.try_emplace({bin.attribute, bin.low}, bin);
        if (is_new) continue;
        at->second.k += bin.k;
        at->second.n_truth += bin.n_truth;
    }
}

/// One entry per method, in order of first appearance, baselines last.
std::vector<Pooled> pool(const std::vector<harness::Row>& rows) {
    std::vector<Pooled> methods;
    for (const harness::Row& row : rows) {
        if (!row.is_ok() || !row.lines) continue;
        auto at = std::find_if(methods.begin(), methods.end(), [&](const Pooled& p) {
            return p.method == row.method;
        });
        if (at == methods.end()) {
            methods.push_back({});
            at = methods.end() - 1;
            at->method = row.method;
        }
        add(*row.lines, *at);
    }
    std::stable_partition(methods.begin(), methods.end(), [](const Pooled& p) {
        return !harness::is_baseline(p.method);
    });
    return methods;
}

std::string px(const std::optional<double>& value, bool is_signed = false) {
    if (!value) return "-";
    // Never a signed zero.
    const double shown = std::abs(*value) < 0.005 ? 0 : *value;
    return is_signed ? fmt::format("{:+.2f}", shown) : fmt::format("{:.2f}", shown);
}

std::optional<double> false_share(const Pooled& p) {
    if (p.positives.n_drawn == 0) return std::nullopt;
    return static_cast<double>(p.positives.n_false) / static_cast<double>(p.positives.n_drawn);
}

std::string place_line(const Pooled& p) {
    return fmt::format(
        "<tr class=\"{}\"><th scope=\"row\">{}</th><td class=\"group\">{}</td><td>{}</td>"
        "<td>{}</td><td class=\"group\">{}</td><td>{}</td><td>{}</td><td class=\"group\">{}</td>"
        "<td>{}</td><td class=\"group\">{}</td></tr>\n",
        harness::is_baseline(p.method) ? "baseline" : "",
        core::escape(p.method),
        core::format_share(p.cracks.f()),
        core::format_share(p.cracks.precision()),
        core::format_share(p.cracks.recall()),
        px(p.offsets.mean(), true),
        px(p.offsets.spread()),
        px(p.offsets.rms()),
        px(p.widths.mean()),
        px(p.widths.spread()),
        core::format_share(false_share(p)));
}

/// White where all is found, full red from a recall of .4 down.
std::string recall_cell(const std::vector<const harness::BinCount*>& bins, std::size_t i) {
    const harness::BinCount* bin = bins[i];
    if (bin == nullptr) return "<td>-</td>";
    const double recall = static_cast<double>(bin->k) / static_cast<double>(bin->n_truth);
    const double t = std::clamp((1 - recall) / 0.6, 0.0, 1.0);
    const auto mix = [t](int to) { return static_cast<int>(255 + (to - 255) * t + 0.5); };
    return fmt::format("<td style=\"background:rgb({},{},{})\" title=\"{} of {} px\">{}</td>",
                       mix(232),
                       mix(138),
                       mix(84),
                       bin->k,
                       bin->n_truth,
                       core::format_share(recall));
}

std::string bin_name(double low, double high) {
    if (std::isinf(low)) return "sky";
    if (std::isinf(high)) return fmt::format("{} up", low);
    return fmt::format("{}–{}", low, high);
}

/// The lower and upper ends of an attribute's bins in which some method has truth.
std::vector<std::pair<double, double>> used_bins(const std::vector<Pooled>& methods,
                                                 std::size_t attribute) {
    std::map<double, double> ends;
    for (const Pooled& p : methods) {
        for (const auto& [key, bin] : p.bins) {
            if (key.first == attribute) ends[bin.low] = bin.high;
        }
    }
    return {ends.begin(), ends.end()};
}

std::string attribute_table(const std::vector<Pooled>& methods, std::size_t attribute) {
    const harness::LineAttribute& a = harness::line_attributes()[attribute];
    const auto ends = used_bins(methods, attribute);
    if (ends.empty()) return "";
    std::string head = "<tr><th scope=\"col\">method</th>";
    for (const auto& [low, high] : ends)
        head += fmt::format("<th scope=\"col\">{}</th>", bin_name(low, high));
    std::string body;
    for (const Pooled& p : methods) {
        if (p.method == "none" || p.method == "oracle") continue;
        std::vector<const harness::BinCount*> bins;
        for (const auto& [low, high] : ends) {
            const auto found = p.bins.find({attribute, low});
            bins.push_back(found == p.bins.end() ? nullptr : &found->second);
        }
        body += fmt::format("<tr class=\"{}\"><th scope=\"row\">{}</th>",
                            harness::is_baseline(p.method) ? "baseline" : "",
                            core::escape(p.method));
        for (std::size_t i = 0; i < bins.size(); ++i)
            body += recall_cell(bins, i);
        body += "</tr>\n";
    }
    return fmt::format(
        "<h3>{}</h3><p class=\"soft\">{}</p><div class=\"scroll\"><table class=\"heat\"><thead>{}"
        "</tr></thead><tbody>{}</tbody></table></div>\n",
        core::escape(a.name),
        core::escape(a.doc),
        head,
        body);
}

}  // namespace

std::string place_html(const std::vector<harness::Row>& rows) {
    const std::vector<Pooled> methods = pool(rows);
    if (methods.empty()) return "";
    std::string body;
    for (const Pooled& p : methods)
        body += place_line(p);
    return fmt::format(
        "<div class=\"scroll\"><table><thead><tr class=\"groups\"><td></td>"
        "<th scope=\"colgroup\" colspan=\"3\" class=\"group\">cracks</th>"
        "<th scope=\"colgroup\" colspan=\"3\" class=\"group\">offset px</th>"
        "<th scope=\"colgroup\" colspan=\"2\" class=\"group\">width px</th>"
        "<th scope=\"colgroup\" class=\"group\">ink</th></tr>"
        "<tr><th scope=\"col\">method</th><th scope=\"col\" class=\"group\">F</th>"
        "<th scope=\"col\">prec.</th><th scope=\"col\">recall</th>"
        "<th scope=\"col\" class=\"group\">mean</th><th scope=\"col\">spread</th>"
        "<th scope=\"col\">rms</th><th scope=\"col\" class=\"group\">mean</th>"
        "<th scope=\"col\">spread</th><th scope=\"col\" class=\"group\">false</th></tr></thead>"
        "<tbody>{}</tbody></table></div>\n",
        body);
}

std::string bins_html(const std::vector<harness::Row>& rows) {
    const std::vector<Pooled> methods = pool(rows);
    std::string tables;
    for (std::size_t a = 0; a < harness::line_attributes().size(); ++a)
        tables += attribute_table(methods, a);
    return tables;
}

}  // namespace ink::report
