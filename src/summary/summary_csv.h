#pragma once

#include <string>
#include <vector>

#include "harness/row.h"
#include "harness/tables/table.h"
#include "statistics/ods.h"

namespace ink::summary {

/// The columns of summary.csv: method, kind, on how much it was scored; F, precision, recall, time
/// and bytes, with their intervals.
[[nodiscard]] const harness::TableInfo& summary_table();

/// A table (RFC 4180, "\n" line ends) with a line per method of `rows`, in order of first
/// appearance, the baselines last; what there is none of is empty. `curves` give average precision;
/// no rows give the heading alone. Numbers are in the shortest form that reads back to the same
/// value.
[[nodiscard]] std::string summary_csv(const std::vector<harness::Row>& rows,
                                      const std::vector<statistics::CellCurve>& curves);

}  // namespace ink::summary
