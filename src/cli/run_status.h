#pragma once

#include <filesystem>
#include <string>

#include "experiment/experiment_plan.h"

namespace ink::cli {

/// How far a run has come, for a terminal: blocks done of all, in its folder `out` and in the
/// shares beside it, `out`.parts/I-of-N, each with the blocks that it is to do. A folder that is
/// not there has none; one of another experiment or build is named and does not count.
[[nodiscard]] std::string run_status(const experiment::Plan& plan,
                                     const std::filesystem::path& out);

}  // namespace ink::cli
