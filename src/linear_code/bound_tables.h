#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/tables/side_table.h"
#include "linear_code/linear_bound_study.h"

namespace ink::linear_code {

/// The row of rows.csv of one scene, or of several taken together: of the method that was asked
/// about, without a view; its counts over all views are in bound.csv.
[[nodiscard]] harness::Row bound_row(const BoundRow& row,
                                     const BoundStudyOptions& options,
                                     int width_px,
                                     int height_px);

/// The columns of bound.csv: cell, views, what the method scored, what its weights and the best
/// ones found come to by the bound's own reckoning, the bound, and the weights found.
[[nodiscard]] const harness::SideTable<BoundRow>& bound_table();

/// The lines of bound.csv with what rows.csv says of their cells. Throws core::Error (file, line,
/// column, value) for another heading, a wrong field or an unknown cell.
[[nodiscard]] std::vector<BoundRow> read_bounds(const harness::CsvTable& csv,
                                                const harness::RowIndex& rows);

}  // namespace ink::linear_code
