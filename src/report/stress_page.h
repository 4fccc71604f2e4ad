#pragma once

#include <string>

#include "experiment/stress.h"

namespace ink::report {

/// A page that needs no other file: the counts, then for each axis what is varied, its chart, what
/// the curves show as measured, and why; the number of every point in a table.
[[nodiscard]] std::string stress_page(const experiment::StressOptions& options,
                                      const experiment::StressResult& result);

}  // namespace ink::report
