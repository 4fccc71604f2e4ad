#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/tables/row_table.h"
#include "studies/motion_rows.h"

namespace ink::studies {

/// The row of rows.csv of one method on one sequence: its view is the path, its image_hash that of
/// all its images; it has no scores and no times.
[[nodiscard]] harness::Row motion_row(const MotionRow& of);

/// The columns of motion.csv: cell, the sequence, then flicker, pops and false lines.
[[nodiscard]] const harness::TableInfo& motion_table();

/// The line of a cell, ended; its scores are empty if it failed.
[[nodiscard]] std::string motion_line(std::int64_t cell, const MotionRow& of);

/// The columns of lives.csv: cell, frames, count.
[[nodiscard]] const harness::TableInfo& lives_table();

/// A line per length of life that a false line of the cell had, each ended; "" without any.
[[nodiscard]] std::string life_lines(std::int64_t cell, const MotionRow& of);

}  // namespace ink::studies
