#pragma once

#include <vector>

#include "lab/summary.h"
#include "lab/svg.h"

namespace ink::lab {

/// Error 1 - F at 2 px against draw time, logarithmic in time: a point per method with its 95 %
/// interval (error) and its quartiles over views (time), the front of methods that none beats in
/// both, and the floor and ceiling rows as lines. Methods without a time or a score are left out;
/// an empty chart says so.
[[nodiscard]] Svg front_chart(const std::vector<MethodSummary>& summaries);

/// Recall per line class at 2 px: a panel per class, a bar per method and for `sampled`.
[[nodiscard]] Svg class_chart(const std::vector<MethodSummary>& summaries);

}  // namespace ink::lab
