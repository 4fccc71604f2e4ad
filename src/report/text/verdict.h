#pragma once

#include <string>
#include <vector>

#include "harness/rows/row.h"
#include "report/text/answer_text.h"
#include "summary/summary_csv.h"

namespace ink::report {

/// How much of a run that is not finished is missing: so many of its parts.
struct Missing {
    int missing_parts = 0;
    int parts = 0;
};

/// A comparison for a terminal: one table, at most 90 columns wide where names have up to 16
/// characters, with a line per method (baselines with a star, methods from outside with a plus);
/// the answer (answer_text.h), and on which parts of the suite it holds; and warnings, a line each.
/// That the run is not finished stands first.
///
/// All else that is known of methods is on the page, and in summary.csv, differences.csv,
/// curves.csv, tolerances.csv and sweep.csv. Ends without a line break. No rows give the sentence
/// alone.
/// `comparison` is of these rows.
[[nodiscard]] std::string verdict_table(const std::vector<harness::Row>& rows,
                                        const summary::Comparison& comparison,
                                        const Missing& missing = {});

/// The same in Markdown, for a README, and the answer as a sentence for a paper.
[[nodiscard]] std::string verdict_markdown(const std::vector<harness::Row>& rows,
                                           const summary::Comparison& comparison,
                                           const Missing& missing = {});

/// The same as a page says it, which has the table itself.
struct VerdictWords {
    AnswerText answer;
    std::string extent;    ///< over what it is, on which parts it holds, how many cells failed
    std::string paper;     ///< the answer as a sentence for a paper; "" without one
    std::string interval;  ///< what those of methods are called
    std::vector<std::string> warnings;
};
[[nodiscard]] VerdictWords verdict_words(const std::vector<harness::Row>& rows,
                                         const summary::Comparison& comparison);

}  // namespace ink::report
