#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/run_data.h"
#include "studies/stress/stress_axes.h"

namespace ink::report {

/// A page that needs no other file: the counts, then for each axis what is varied, its chart and
/// what the curves show as measured; the number of every point in a table.
[[nodiscard]] std::string stress_page(const experiment::RunData& run);

/// Writes the page as `folder`/stress.html and each axis' chart as figures/stress_<axis>.svg.
/// Throws core::Error if that cannot be. Returns the page's path.
std::filesystem::path write_stress_page(const experiment::RunData& run,
                                        const std::filesystem::path& folder);

}  // namespace ink::report
