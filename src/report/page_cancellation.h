#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "linear_code/cancellation.h"

namespace ink::report {

/// What the part on cancellation is about.
[[nodiscard]] std::string_view cancellation_intro();

/// Predicted and measured miss rates of the methods that declare a code, as a chart and as a table
/// by class, with the largest difference in words; "" without rows.
[[nodiscard]] std::string cancellation_html(const std::vector<linear_code::CancellationRow>& rows);

}  // namespace ink::report
