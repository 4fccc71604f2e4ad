#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/tables/row_table.h"
#include "linear_code/cancellation.h"

namespace ink::linear_code {

/// The columns of cancellation.csv: cell, silent_deg, class, dihedral_low_deg, dihedral_high_deg,
/// then counts.
[[nodiscard]] const harness::TableInfo& cancellation_table();

/// The line of one kind of line of a cell, ended; a boundary's bin is two empty fields.
[[nodiscard]] std::string cancellation_line(std::int64_t cell, const CancellationRow& row);

}  // namespace ink::linear_code
