#pragma once

#include <vector>

#include "linear_code/cancellation.h"
#include "report/svg.h"

namespace ink::report {

/// Kinds with fewer true pixels are not drawn: one pixel of them is more than a percent.
inline constexpr std::int64_t kFewPixels = 100;

/// Predicted against measured miss rates, a row of two panels per method: left a point per kind of
/// line, predicted across and measured upwards, between lines two points off the diagonal; right
/// both rates against the dihedral, a colour per class, with what the law asks of any linear sum
/// (linear_code/cancellation_law.h). Kinds of fewer than kFewPixels are left out; without rows it
/// says so.
[[nodiscard]] Svg cancellation_chart(const std::vector<linear_code::CancellationRow>& rows);

}  // namespace ink::report
