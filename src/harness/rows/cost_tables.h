#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/rows/row_table.h"

namespace ink::harness {

/// The columns of cost.csv: cell, then what the cost model is made from.
[[nodiscard]] const core::TableOf<RowRecord>& cost_table();

/// The line of a cell, ended; "" if its row has no cost facts.
[[nodiscard]] std::string cost_line(std::int64_t cell, const Row& row);

/// Puts the cost facts of cost.csv into their rows. Throws core::Error (file, line,
/// column, value) for another heading, a wrong field, or a cell that `rows` does not have.
void join_costs(const core::CsvTable& csv, std::vector<RowRecord>& rows);

}  // namespace ink::harness
