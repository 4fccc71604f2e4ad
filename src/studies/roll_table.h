#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/tables/row_table.h"
#include "studies/roll_study.h"

namespace ink::studies {

/// The row of rows.csv of one method on the rolling cube, which has a curve per crease; it has no
/// scores and no times.
[[nodiscard]] harness::Row roll_row(const RollCurve& curve, const RollOptions& options);

/// The columns of roll.csv: cell, crease, roll_deg, length_px, covered_px, predicted_step,
/// predicted_blind.
[[nodiscard]] const harness::TableInfo& roll_table();

/// A line per angle, each ended.
[[nodiscard]] std::string roll_lines(std::int64_t cell, const RollCurve& curve);

/// The columns of vanishing.csv: cell, crease, predicted_deg, measured_deg, error_deg,
/// recall_there.
[[nodiscard]] const harness::TableInfo& vanishing_table();

/// A line per predicted angle, each ended; "" without any.
[[nodiscard]] std::string vanishing_lines(std::int64_t cell, const RollCurve& curve);

}  // namespace ink::studies
