#pragma once

#include <map>
#include <optional>
#include <string>
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
    std::vector<PairedDifference> differences = {};       ///< of F at 2 px, of all pairs
    std::vector<PairedDifference> soft_differences = {};  ///< of soft F, where that is there
    std::vector<double> shares = {};                      ///< of each summary: answer_shares()

    /// Points into the summaries.
    [[nodiscard]] Answer answer() const { return find_answer(summaries, rule); }
    /// By what methods are judged: soft F where they have it.
    [[nodiscard]] Measure measure() const;
};

/// Of rows of one size and number of threads.
[[nodiscard]] Comparison compare_methods(const std::vector<harness::Row>& rows,
                                         const AnswerRule& rule = {});

/// summary.csv, differences.csv and what else its methods have, by name: `rows` are its rows.
[[nodiscard]] std::map<std::string, std::string> comparison_tables(
    const std::vector<harness::Row>& rows, const Comparison& comparison);

}  // namespace ink::summary
