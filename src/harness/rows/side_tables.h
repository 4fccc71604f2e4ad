#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/param.h"
#include "core/tables/table_of.h"
#include "harness/rows/row_table.h"
#include "harness/scores/bins.h"
#include "score/score.h"
#include "statistics/ods.h"

namespace ink::harness {

/// What a side table says of a cell.
template <class T>
struct OfCell : T {
    std::int64_t cell = 0;
};

/// A table that says more of the cells of rows.csv: its first column names the cell.
template <class T>
class SideTable : public core::TableOf<OfCell<T>> {
  public:
    SideTable(std::string file, std::string doc)
        : core::TableOf<OfCell<T>>(std::move(file), std::move(doc)) {
        this->add({"cell", "", "of rows.csv"}, &OfCell<T>::cell);
    }

    /// One line with its line break.
    [[nodiscard]] std::string line(std::int64_t cell, const T& of) const {
        return core::TableOf<OfCell<T>>::line({of, cell});
    }

    /// What all lines say, each completed by `complete(record, row)` from the row of its cell.
    /// Throws core::Error for other columns than these, a wrong field, or a cell that `rows` does
    /// not have.
    template <class Complete>
    [[nodiscard]] std::vector<T> read_with_rows(const core::CsvTable& csv,
                                                const RowIndex& rows,
                                                const Complete& complete) const {
        std::vector<T> all;
        for (OfCell<T>& record : this->read(csv)) {
            complete(record, rows.find(core::CsvField(csv, all.size(), 0)).row);
            all.push_back(std::move(record));
        }
        return all;
    }
};

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

/// The columns of cost.csv: cell, then what the cost model is made from.
[[nodiscard]] const core::TableOf<RowRecord>& cost_table();

/// The line of a cell, ended; "" if its row has no cost facts.
[[nodiscard]] std::string cost_line(std::int64_t cell, const Row& row);

/// Puts the cost facts of cost.csv into their rows. Throws core::Error (file, line,
/// column, value) for another heading, a wrong field, or a cell that `rows` does not have.
void join_costs(const core::CsvTable& csv, std::vector<RowRecord>& rows);

/// The columns of sweep.csv that not every run has.
struct SweepColumns {
    std::vector<std::string> parameters;
    bool has_ink = false;  ///< soft F, and the ink that it is made of
};

/// The columns of sweep.csv: cell (of the same method at its own settings on the same view),
/// setting, status, one per parameter of `swept`, then counts, scores, times and cost. Throws
/// core::Error if a parameter is called as another column is.
[[nodiscard]] core::TableInfo sweep_table(const SweepColumns& swept);

/// The line of one setting, ended; `setting` counts from 1 within the cell. The fields of `swept`
/// are taken from the row's params, empty where the method has no such parameter.
[[nodiscard]] std::string sweep_line(std::int64_t cell,
                                     int setting,
                                     const SweepColumns& swept,
                                     const Row& row);

/// Those that a sweep.csv has.
[[nodiscard]] SweepColumns sweep_columns(const core::CsvTable& csv);

/// The settings of sweep.csv, in order: each as the row of its cell, but for `setting`, params,
/// status, and what else sweep.csv holds; what could change with the settings and is no column of
/// it is empty. Throws core::Error (file, line, column, value) for another heading, a wrong field
/// or a cell that `rows` does not have.
[[nodiscard]] std::vector<Row> read_sweep(const core::CsvTable& csv, const RowIndex& own);

/// What join_params (harness/cells/cell.h) wrote.
[[nodiscard]] core::ParamValues split_params(const std::string& params);

}  // namespace ink::harness
