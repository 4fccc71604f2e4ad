#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/tables/row_table.h"
#include "studies/axis_rows.h"

namespace ink::studies {

/// The columns of stress.csv: cell, non_finite, overflow, lost_cell, differing.
[[nodiscard]] const harness::TableInfo& faults_table();

/// The line of a cell, ended; its row is a line of rows.csv.
[[nodiscard]] std::string faults_line(std::int64_t cell, const CaseFaults& faults);

/// The lines of stress.csv with the rows of their cells. Throws core::Error (file, line, column,
/// value) for another heading, a wrong field or an unknown cell.
[[nodiscard]] std::vector<AxisRow> read_faults(const harness::CsvTable& csv,
                                               const harness::RowIndex& rows);

/// axes.csv: what each axis of a run varies, for who reads its values.
[[nodiscard]] const harness::TableInfo& axes_table();
[[nodiscard]] std::string axis_line(const Axis& axis);

}  // namespace ink::studies
