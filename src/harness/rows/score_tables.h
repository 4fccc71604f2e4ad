#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "harness/rows/side_table.h"
#include "harness/scores/bins.h"
#include "score/score.h"
#include "statistics/ods.h"

namespace ink::harness {

/// Counts of a cell at one of many thresholds or tolerances.
template <class At>
struct CountsAt {
    At at = 0;
    score::CurveCount counts;
};

/// The columns of curves.csv: cell, threshold, k, n_pred, n_truth.
[[nodiscard]] const SideTable<CountsAt<int>>& curves_table();

/// The 99 lines of a cell, each ended: threshold = 1..99 hundredths of the full edge response.
[[nodiscard]] std::string curve_lines(std::int64_t cell,
                                      const std::array<score::CurveCount, 99>& counts);

/// The curve of a cell.
struct CurveRecord {
    std::int64_t cell = 0;
    statistics::CellCurve curve;  ///< with the method of its row
};

/// The curves of curves.csv, in order. Throws core::Error (file, line, column, value) for another
/// heading, a wrong field, a cell that `rows` does not have, or a cell without just the thresholds
/// 1..99 in a row.
[[nodiscard]] std::vector<CurveRecord> read_curves(const core::CsvTable& csv, const RowIndex& rows);

/// The columns of tolerances.csv: cell, tolerance_px, k, n_pred, n_truth.
[[nodiscard]] const SideTable<CountsAt<double>>& tolerances_table();

/// A line per tolerance at which the cell was scored (kTolerances_px), each ended; "" for none.
[[nodiscard]] std::string tolerance_lines(std::int64_t cell,
                                          const std::vector<score::CurveCount>& counts);

/// Puts the counts of tolerances.csv into the `tolerance_sweep` of their rows. Throws core::Error
/// as read_curves does, here for a cell without just the tolerances of kTolerances_px in a row.
void join_tolerances(const core::CsvTable& csv, std::vector<RowRecord>& rows);

/// The columns of bins.csv: cell, attribute, low, high, k, n_truth.
[[nodiscard]] const SideTable<BinCount>& bins_table();

/// The lines of one cell, one a bin that has true pixels, each ended; "" if none has. Infinity is
/// "inf".
[[nodiscard]] std::string bin_lines(std::int64_t cell, const std::vector<BinCount>& bins);

/// Puts the counts of bins.csv into their rows, behind what is there. Throws core::Error as
/// read_curves does; the row of a cell must have a score.
void join_bins(const core::CsvTable& csv, std::vector<RowRecord>& rows);

}  // namespace ink::harness
