#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/tables/row_table.h"
#include "studies/skip_study.h"

namespace ink::studies {

/// The row of rows.csv of one method on one scene in one arm: skips_off tells the arms apart, and
/// the view is called as the scene. It has no scores.
[[nodiscard]] harness::Row skip_row(const SkipTime& time, const SkipStudyOptions& options);

/// The columns of skips.csv: cell, skip, arm.
[[nodiscard]] const harness::TableInfo& skips_table();

/// The line of a cell, ended.
[[nodiscard]] std::string skip_line(std::int64_t cell, const SkipTime& time);

}  // namespace ink::studies
