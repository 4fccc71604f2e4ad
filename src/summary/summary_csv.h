#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/tables/table_of.h"
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

/// The columns of summary.csv: method, kind, on how much it was scored; F, precision, recall, time
/// and bytes, with their intervals; soft F where methods have it.
[[nodiscard]] const core::TableInfo& summary_table(bool has_soft_f = true);

/// A table (RFC 4180, "\n" line ends) with a line per method of `rows`, in order of first
/// appearance, the baselines last; what there is none of is empty. `comparison` is of these rows;
/// no rows give the heading alone. Numbers are in the shortest form that reads back to the same
/// value.
[[nodiscard]] std::string summary_csv(const std::vector<harness::Row>& rows,
                                      const Comparison& comparison);

/// kinds.csv: F, and soft F where methods have it, of each method over scenes of each kind; ""
/// where no row has a kind.
[[nodiscard]] core::TableInfo kinds_table();
[[nodiscard]] std::string kinds_csv(const std::vector<MethodSummary>& summaries);

/// Cells without a score for one and the same reason, on one view.
struct Unscored {
    std::string scene;
    std::string view;
    std::string method;  ///< "" where no method of the view has a score
    std::string reason;  ///< the rows' status
    std::string remedy;  ///< what may help, in a sentence
};

/// Every view and every cell of `rows` that has no score, in their order: one entry for a view that
/// has none at all, else one for each method that failed there.
[[nodiscard]] std::vector<Unscored> unscored_cells(const std::vector<harness::Row>& rows);

/// Whether something went wrong there. A crowded view did not: it has no part in headline numbers,
/// but every cell of it has its f_2px_with_crowded.
[[nodiscard]] bool is_failure(const Unscored& cell);

/// Whether not one cell of a method has a score; false where there are none.
[[nodiscard]] bool is_all_unscored(const std::vector<harness::Row>& rows);

/// unscored.csv: the same as a table of the run folder.
[[nodiscard]] const core::TableOf<Unscored>& unscored_table();
/// For a terminal: a line per entry, its remedy below; "" if all have scores.
[[nodiscard]] std::string unscored_text(const std::vector<Unscored>& cells);

}  // namespace ink::summary
