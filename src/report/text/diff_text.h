#pragma once

#include <string>

#include "experiment/diff/run_diff.h"

namespace ink::report {

/// What differs between two runs, for a terminal: what was asked differently, cells that are new or
/// gone, then a line for every method that changed, those with changed images first, and how many
/// did not. Times stand there only where they compare; a line says why where they do not. One
/// sentence if nothing differs.
[[nodiscard]] std::string diff_text(const experiment::RunDiff& diff);

}  // namespace ink::report
