#pragma once

#include <vector>

#include "harness/rows/side_table.h"
#include "studies/axis_rows.h"

namespace ink::studies {

/// The columns of stress.csv: cell, non_finite, overflow, lost_cell, differing.
[[nodiscard]] const harness::SideTable<AxisRow>& faults_table();

/// The lines of stress.csv with the rows of their cells. Throws core::Error (file, line, column,
/// value) for another heading, a wrong field or an unknown cell.
[[nodiscard]] std::vector<AxisRow> read_faults(const core::CsvTable& csv,
                                               const harness::RowIndex& rows);

/// axes.csv: what each axis of a run varies, for who reads its values.
[[nodiscard]] const core::TableOf<Axis>& axes_table();

}  // namespace ink::studies
