#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/tables/row_table.h"
#include "studies/scaling.h"

namespace ink::studies {

/// The row of rows.csv of one method at one place on one axis; the view is axis and place, as in
/// "pixels=921600". It has no scores.
[[nodiscard]] harness::Row scaling_row(const ScalingPoint& point);

/// Empties what holds times: two runs then have the same lines.
void clear_times(ScalingPoint& point);

/// The columns of scaling.csv: cell, axis, x, covered_share, noise.
[[nodiscard]] const harness::TableInfo& scaling_table();

/// The line of a cell, ended; its noise is empty if nothing was timed.
[[nodiscard]] std::string scaling_line(std::int64_t cell, const ScalingPoint& point);

}  // namespace ink::studies
