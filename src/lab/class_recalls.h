#pragma once

#include <map>
#include <string>
#include <vector>

#include "lab/row.h"
#include "lab/spread.h"

namespace ink::lab {

/// The 95 % interval of each class's recall pooled over `rows`, which are of one method: scenes
/// drawn again with all their views, as f_interval does it with the rows' seed.
///
/// A class that is there in fewer than two scenes has none; rows that failed are left out.
[[nodiscard]] std::map<std::string, Interval> class_recall_intervals(
    const std::vector<const Row*>& rows);

/// The rows of `method`, those that failed left out.
[[nodiscard]] std::vector<const Row*> rows_of_method(const std::vector<Row>& rows,
                                                     const std::string& method);

}  // namespace ink::lab
