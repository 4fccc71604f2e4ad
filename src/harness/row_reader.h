#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/csv_table.h"
#include "harness/row.h"
#include "statistics/ods.h"

namespace ink::harness {

/// The rows of a table with the columns of rows.csv (rows.csv, sweep.csv): to_csv of what is read
/// gives the same fields again.
///
/// Provenance is not part of a row and is not read; of sums behind means and spreads, which are no
/// columns, some are chosen that give the same means. Columns that are not known are passed over.
/// Throws core::Error (where = `where` and the record's number) that names column and field for
/// text that no such field holds, or a missing column that every row needs.
[[nodiscard]] std::vector<Row> read_rows(const CsvTable& table, const std::string& where);

/// The curves of curves.csv, one per cell, in order; `rows` tell which cells are methods' and
/// train. Throws core::Error as read_rows does.
[[nodiscard]] std::vector<statistics::CellCurve> read_curves(const CsvTable& table,
                                                             const std::vector<Row>& rows,
                                                             const std::string& where);

}  // namespace ink::harness
