#pragma once

#include <string>
#include <vector>

#include "harness/row.h"
#include "summary/answer.h"

namespace ink::report {

/// What a verdict depends on beside the rows.
struct VerdictOptions {
    summary::AnswerRule rule = {};
    int missing_parts = 0;  ///< of a run that is not finished,
    int parts = 0;          ///< of so many
};

/// A comparison for a terminal: one table, at most 90 columns wide where names have up to 16
/// characters, with a line per method (baselines with a star, methods from outside with a plus);
/// the answer (answer_text.h), and on which parts of the suite it holds; and warnings, a line each.
/// That the run is not finished stands first.
///
/// All else that is known of methods is on the page, and in summary.csv, differences.csv,
/// curves.csv, tolerances.csv and sweep.csv. Ends without a line break. No rows give the sentence
/// alone.
[[nodiscard]] std::string verdict_table(const std::vector<harness::Row>& rows,
                                        const VerdictOptions& options = {});

/// The same in Markdown, for a README, and the answer as a sentence for a paper.
[[nodiscard]] std::string verdict_markdown(const std::vector<harness::Row>& rows,
                                           const VerdictOptions& options = {});

}  // namespace ink::report
