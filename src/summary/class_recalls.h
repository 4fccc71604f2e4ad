#pragma once

#include <map>
#include <string>
#include <vector>

#include "harness/row.h"
#include "statistics/spread.h"

namespace ink::summary {

/// The 95 % interval of each class's recall pooled over `rows`, which are of one method: scenes
/// resampled with all their views, as f_interval does it with the rows' seed.
///
/// A class that is there in fewer than two scenes has none; rows that failed are left out.
[[nodiscard]] std::map<std::string, statistics::Interval> class_recall_intervals(
    const std::vector<const harness::Row*>& rows);

/// The rows of `method`, those that failed left out.
[[nodiscard]] std::vector<const harness::Row*> rows_of_method(const std::vector<harness::Row>& rows,
                                                              const std::string& method);

}  // namespace ink::summary
