#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/param.h"
#include "harness/rows/row_table.h"

namespace ink::harness {

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
