#pragma once

#include <string>
#include <vector>

#include "harness/suite.h"
#include "tune/tune.h"

namespace ink::tune {

/// Beside what a search found, the most that any four weights of the method's code could score on
/// the training scenes and on the held-out ones (linear_code/linear_bound.h), as lines for a
/// terminal: F of the tuned settings, the bound, how far below it they stay, and how certain the
/// bound is. "" for a method that declares no linear code; the reason in a line where its code has
/// no bound.
[[nodiscard]] std::string tune_bound_lines(const std::vector<harness::SceneViews>& scenes,
                                           const TuneResult& result,
                                           const TuneOptions& options);

}  // namespace ink::tune
