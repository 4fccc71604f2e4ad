#include "lab/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "lab/leads.h"
#include "truth/line_class.h"

namespace ink::lab {
namespace {

/// A column of a table: its heading and the text it holds for a method.
struct Column {
    std::string heading;
    std::function<std::string(const MethodSummary&)> text;
};

Column share_column(std::string heading, std::optional<double> MethodSummary::*field) {
    return {std::move(heading), [field](const MethodSummary& s) { return format_share(s.*field); }};
}

/// Names come from the registry, but a table keeps its width whatever they are.
std::string method_name(const MethodSummary& s) {
    constexpr std::size_t kLongest = 18;
    const std::string name = s.method + (s.is_bracket ? " *" : "");
    return name.size() <= kLongest ? name : name.substr(0, kLongest - 2) + "..";
}

Column name_column() {
    return {"method", method_name};
}

/// "36", or "35/36" where a cell failed.
std::string views_of(const MethodSummary& s) {
    const std::string views = fmt::format("{}", s.views);
    return s.failed == 0 ? views : fmt::format("{}/{}", views, s.views + s.failed);
}

std::vector<Column> main_columns() {
    return {
        name_column(),
        share_column("F 2px", &MethodSummary::f_2px),
        share_column("train", &MethodSummary::f_train),
        share_column("held-out", &MethodSummary::f_heldout),
        share_column("macro", &MethodSummary::f_macro),
        share_column("median", &MethodSummary::f_median),
        share_column("F 1px", &MethodSummary::f_1px),
        share_column("prec.", &MethodSummary::precision),
        share_column("recall", &MethodSummary::recall),
        {"width",
         [](const MethodSummary& s) {
             return s.mean_width_px ? fmt::format("{:.2f}", *s.mean_width_px) : "-";
         }},
        {"draw ms", [](const MethodSummary& s) { return format_ms(s.draw_ms); }},
        {"B/px",
         [](const MethodSummary& s) {
             return s.bytes_per_px ? fmt::format("{}", *s.bytes_per_px) : "-";
         }},
        {"views", views_of},
    };
}

/// One column per class that some view has.
std::vector<Column> class_columns(const std::vector<MethodSummary>& summaries) {
    std::vector<Column> columns;
    for (const truth::LineClass c : truth::kLineClasses) {
        const std::string name(truth::name(c));
        const bool is_there =
            std::any_of(summaries.begin(), summaries.end(), [&](const MethodSummary& s) {
                return s.recall_by_class.count(name) != 0;
            });
        if (!is_there) continue;
        columns.push_back({name, [name](const MethodSummary& s) {
                               const auto found = s.recall_by_class.find(name);
                               return found == s.recall_by_class.end()
                                          ? "-"
                                          : format_share(found->second);
                           }});
    }
    return columns;
}

using Cells = std::vector<std::vector<std::string>>;

/// Headings first, then a line per method.
Cells cells_of(const std::vector<Column>& columns, const std::vector<MethodSummary>& summaries) {
    Cells cells(1);
    for (const Column& column : columns)
        cells[0].push_back(column.heading);
    for (const MethodSummary& s : summaries) {
        std::vector<std::string>& line = cells.emplace_back();
        for (const Column& column : columns)
            line.push_back(column.text(s));
    }
    return cells;
}

std::string aligned(const Cells& cells) {
    std::vector<std::size_t> widths(cells[0].size(), 0);
    for (const auto& line : cells) {
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], line[i].size());
    }
    std::string text;
    for (const auto& line : cells) {
        text += fmt::format("{:<{}}", line[0], widths[0]);
        for (std::size_t i = 1; i < line.size(); ++i)
            text += fmt::format("  {:>{}}", line[i], widths[i]);
        text += '\n';
    }
    return text;
}

std::string markdown(const Cells& cells) {
    std::string text;
    for (const auto& line : cells) {
        text += fmt::format("| {} |\n", fmt::join(line, " | "));
        if (&line != &cells.front()) continue;
        text += "|---|";
        for (std::size_t i = 1; i < line.size(); ++i)
            text += "--:|";
        text += '\n';
    }
    return text;
}

constexpr const char* kBracketNote =
    "* brackets, not methods: `none` draws nothing, `sampled` sees the exact lines once per pixel "
    "centre,\n  `oracle` is the truth itself.";

/// ", 12.3 ms a frame, 4.1 times as long as the cheapest, mote2 (3.00 ms, F .803)."
std::string cost_of(const Verdict& verdict) {
    const MethodSummary& best = *verdict.best;
    const MethodSummary* cheapest = verdict.cheapest;
    if (!best.draw_ms) return "; no time was taken.";
    const std::string cost = fmt::format(", {} ms a frame", format_ms(best.draw_ms));
    if (verdict.runner_up == nullptr) return cost + ".";
    if (cheapest == &best) return cost + ", which is also the cheapest.";
    return fmt::format("{}, {:.1f} times as long as the cheapest, {} ({} ms, F {}).",
                       cost,
                       *best.draw_ms / *cheapest->draw_ms,
                       cheapest->method,
                       format_ms(cheapest->draw_ms),
                       format_share(cheapest->f_2px));
}

/// A lead that chance could have made is said to be one.
std::string doubt(const std::vector<Row>& rows, const Verdict& verdict) {
    if (verdict.runner_up == nullptr) return "";
    const auto lead = lead_of(rows, verdict.best->method, verdict.runner_up->method);
    if (!lead || !lead->range || lead->is_beyond_chance()) return "";
    return fmt::format(
        " These views cannot tell it from {} (F {}): the 95 % interval of the "
        "difference holds 0.",
        verdict.runner_up->method,
        format_share(verdict.runner_up->f_2px));
}

std::string failures(const std::vector<MethodSummary>& summaries) {
    int failed = 0;
    for (const MethodSummary& s : summaries)
        failed += s.failed;
    if (failed == 0) return "";
    return fmt::format(" {} cell{} failed and enter{} no number here.",
                       failed,
                       failed == 1 ? "" : "s",
                       failed == 1 ? "s" : "");
}

}  // namespace

std::string format_share(const std::optional<double>& share) {
    if (!share) return "-";
    const std::string text = fmt::format("{:.3f}", *share);
    return text[0] == '0' ? text.substr(1) : text;
}

std::string format_ms(const std::optional<double>& ms) {
    if (!ms) return "-";
    // What rounds to 10 or 100 is shown as such: 9.996 is "10.0", not "10.00".
    const int decimals = *ms < 0.0995 ? 3 : *ms < 9.995 ? 2 : *ms < 99.95 ? 1 : 0;
    return fmt::format("{:.{}f}", *ms, decimals);
}

std::string verdict_details(const std::vector<Row>& rows,
                            const std::vector<MethodSummary>& summaries) {
    const Verdict verdict = find_verdict(summaries);
    if (verdict.best == nullptr) {
        return "No method was scored on any view, so there is no verdict." + failures(summaries);
    }
    const MethodSummary& best = *verdict.best;
    return fmt::format("F {} at 2 px over {} view{} pooled{}{}{}",
                       format_share(best.f_2px),
                       best.views,
                       best.views == 1 ? "" : "s",
                       cost_of(verdict),
                       doubt(rows, verdict),
                       failures(summaries));
}

std::string verdict_headline(const Verdict& verdict) {
    if (verdict.best == nullptr) return "No verdict: no method was scored";
    const bool is_alone = verdict.runner_up == nullptr;
    return verdict.best->method +
           (is_alone ? " is the only method scored" : " makes the fewest errors");
}

std::string verdict_sentence(const std::vector<Row>& rows,
                             const std::vector<MethodSummary>& summaries) {
    const Verdict verdict = find_verdict(summaries);
    const std::string details = verdict_details(rows, summaries);
    if (verdict.best == nullptr) return details;
    return fmt::format("{}: {}", verdict_headline(verdict), details);
}

std::string verdict_table(const std::vector<Row>& rows) {
    const std::vector<MethodSummary> summaries = summarise(rows);
    const std::string sentence = verdict_sentence(rows, summaries);
    if (summaries.empty()) return sentence;
    std::string text = aligned(cells_of(main_columns(), summaries));
    std::vector<Column> classes = class_columns(summaries);
    if (!classes.empty()) {
        classes.insert(classes.begin(), name_column());
        text += "\nrecall of\n" + aligned(cells_of(classes, summaries));
    }
    return fmt::format("{}\n{}\n\n{}", text, kBracketNote, sentence);
}

std::string verdict_markdown(const std::vector<Row>& rows) {
    const std::vector<MethodSummary> summaries = summarise(rows);
    const std::string sentence = verdict_sentence(rows, summaries);
    if (summaries.empty()) return sentence + "\n";
    std::vector<Column> columns = main_columns();
    for (Column& column : class_columns(summaries)) {
        columns.push_back({"recall " + column.heading, column.text});
    }
    return markdown(cells_of(columns, summaries)) + "\n" + sentence + "\n";
}

}  // namespace ink::lab
