#pragma once

#include "harness/tables/side_table.h"
#include "linear_code/cancellation.h"

namespace ink::linear_code {

/// The columns of cancellation.csv: cell, silent_deg, class, dihedral_low_deg, dihedral_high_deg,
/// then counts. A boundary's bin is two empty fields.
[[nodiscard]] const harness::SideTable<CancellationRow>& cancellation_table();

}  // namespace ink::linear_code
