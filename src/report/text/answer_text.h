#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/row.h"
#include "summary/answer.h"
#include "summary/paired_differences.h"
#include "summary/summary.h"

namespace ink::report {

/// Whether names are set off as in Markdown.
enum class Markup { none, markdown };

/// Milliseconds with three digits that count: "0.042", "3.10", "12.3", "1234"; "-" for nothing.
[[nodiscard]] std::string format_ms(const std::optional<double>& ms);

/// The answer in sentences: the method and what it takes; the most exact (or the next) with what it
/// takes more and the paired difference; what its interval is worth, or that there are too few
/// scenes for one. `answer.js` says the same of what a page's filters leave. `differences` are of
/// all pairs.
[[nodiscard]] std::string answer_sentences(
    const std::vector<harness::Row>& rows,
    const std::vector<summary::MethodSummary>& summaries,
    const std::vector<summary::PairedDifference>& differences,
    const summary::AnswerRule& rule,
    Markup markup);

/// The answer as a sentence for a paper; "" without one.
[[nodiscard]] std::string paper_sentence(const std::vector<harness::Row>& rows,
                                         const std::vector<summary::MethodSummary>& summaries,
                                         const std::vector<summary::PairedDifference>& differences,
                                         const summary::AnswerRule& rule);

}  // namespace ink::report
