#pragma once

#include <string>
#include <vector>

#include "harness/row.h"

namespace ink::report {

/// Cracks, place and width of each method's lines, pooled over its views, as an HTML table; "" if
/// no row has line scores.
[[nodiscard]] std::string place_html(const std::vector<harness::Row>& rows);

/// Recall of each method in the bins of each line attribute, pooled over its views, as HTML tables
/// whose cells are the darker the more is missed; "" if no row has bins.
[[nodiscard]] std::string bins_html(const std::vector<harness::Row>& rows);

}  // namespace ink::report
