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

/// The curves of both files, by cell and crease as roll.csv has them, with what rows.csv says of
/// their cells. Angles are good to ten digits. Throws core::Error (file, line, column, value) for
/// another heading, a wrong field, an unknown cell or a curve that roll.csv does not have.
[[nodiscard]] std::vector<RollCurve> read_rolls(const harness::CsvTable& roll,
                                                const harness::CsvTable& vanishing,
                                                const harness::RowIndex& rows);

}  // namespace ink::studies
