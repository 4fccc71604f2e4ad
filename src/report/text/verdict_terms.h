#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiment/summary/paired_differences.h"
#include "experiment/summary/summary.h"
#include "harness/row.h"
#include "report/text/text_table.h"
#include "statistics/ods.h"

namespace ink::report {

/// What goes beyond the pooled F: the random baseline, thresholds (ODS, OIS, AP) and the tolerance
/// sweep. Columns that no summary has anything for are left out; none is left if nothing is.
[[nodiscard]] std::vector<TextColumn> statistics_columns(
    const std::vector<experiment::MethodSummary>& summaries);

/// The matrix of paired differences: a line per method, best first, by how much it leads each
/// other. Empty with fewer than two methods.
[[nodiscard]] core::Cells paired_difference_cells(
    const std::vector<experiment::PairedDifference>& differences);

/// What the words in the tables mean, a sentence each, in the order in which they appear.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& definitions();

/// A line per method: the best threshold over the training scenes, F at it and at the method's own.
/// "" if no training scene took part.
[[nodiscard]] std::string threshold_lines(const std::vector<harness::Row>& rows,
                                          const std::vector<statistics::CellCurve>& curves);

}  // namespace ink::report
