#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/rows/row.h"
#include "summary/summary_csv.h"

namespace ink::report {

/// Whether names are set off as in Markdown.
enum class Markup { none, markdown };

/// Milliseconds with three digits that count: "0.042", "3.10", "12.3", "1234"; "-" for nothing.
[[nodiscard]] std::string format_ms(const std::optional<double>& ms);

/// What a method is judged by: "F", or "soft F".
[[nodiscard]] std::string measure_text(summary::Measure measure);
/// What that is of: "at 2 px", or "of lines 1.5 px wide".
[[nodiscard]] std::string measure_extent(const std::vector<harness::Row>& rows,
                                         summary::Measure measure);

/// Which methods may be the answer where times move: "another run may name `a`, `b`: ...";
/// "" for none.
[[nodiscard]] std::string times_text(const summary::Answer& answer, Markup markup);

/// The answer in sentences.
struct AnswerText {
    /// The finding: how much of the outline (of ink, where that is scored) the method finds, how
    /// much of what it draws is right, and its time; without its full stop, as a heading.
    std::string first;
    /// Why: the rule, the most exact (or the next) with what it takes more and the paired
    /// difference, or that there are too few scenes for an interval. "" without an answer.
    std::string rest;

    [[nodiscard]] std::string whole() const {
        return first + "." + (rest.empty() ? "" : " ") + rest;
    }
};
[[nodiscard]] AnswerText answer_text(const std::vector<harness::Row>& rows,
                                     const summary::Comparison& comparison,
                                     Markup markup);

/// The answer as a sentence for a paper; "" without one.
[[nodiscard]] std::string paper_sentence(const std::vector<harness::Row>& rows,
                                         const summary::Comparison& comparison);

}  // namespace ink::report
