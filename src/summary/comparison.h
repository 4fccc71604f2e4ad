#pragma once

#include <optional>
#include <vector>

#include "core/tables/csv_table.h"
#include "harness/rows/row.h"
#include "summary/answer.h"
#include "summary/paired_differences.h"
#include "summary/summary.h"

namespace ink::summary {

/// What the rows of a comparison say together: worked out once, then written, printed and drawn.
struct Comparison {
    AnswerRule rule = {};
    std::vector<MethodSummary> summaries = {};
    std::vector<PairedDifference> differences = {};  ///< of all pairs
    std::vector<double> shares = {};                 ///< of each summary: answer_shares()

    /// Points into the summaries.
    [[nodiscard]] Answer answer() const { return find_answer(summaries, rule); }
};

/// Of rows of one size and number of threads.
[[nodiscard]] Comparison compare_methods(const std::vector<harness::Row>& rows,
                                         const AnswerRule& rule = {});

/// The same, with what is resampled read back from summary.csv and differences.csv of these rows
/// and this rule; nothing if other columns say that another version wrote them.
[[nodiscard]] std::optional<Comparison> read_comparison(const std::vector<harness::Row>& rows,
                                                        const AnswerRule& rule,
                                                        const core::CsvTable& summary,
                                                        const core::CsvTable& differences);

}  // namespace ink::summary
