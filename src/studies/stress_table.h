#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/tables/row_table.h"
#include "studies/stress/stress_rows.h"

namespace ink::studies {

/// The columns of stress.csv: cell, axis, value, unit, non_finite, overflow, lost_cell, differing.
[[nodiscard]] const harness::TableInfo& stress_table();

/// The line of a cell, ended; its row is a line of rows.csv.
[[nodiscard]] std::string stress_line(std::int64_t cell, const StressRow& row);

/// The lines of stress.csv with the rows of their cells. Throws core::Error (file, line, column,
/// value) for another heading, a wrong field or an unknown cell.
[[nodiscard]] std::vector<StressRow> read_stress(const harness::CsvTable& csv,
                                                 const harness::RowIndex& rows);

}  // namespace ink::studies
