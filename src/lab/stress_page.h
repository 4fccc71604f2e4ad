#pragma once

#include <string>

#include "lab/stress.h"

namespace ink::lab {

/// A page that needs no other file: the counts, then for each axis what is varied, its chart, what
/// the curves show as measured, and why; the number of every point in a table.
[[nodiscard]] std::string stress_page(const StressOptions& options, const StressResult& result);

}  // namespace ink::lab
