#pragma once

#include <filesystem>

#include "experiment/experiment_run.h"

namespace ink::cli {

/// Shows what came of a run in `folder`: the table of methods with the verdict, or that of
/// stress; every view without a score with its reason and a remedy; where page and tables are.
///
/// Writes report.html, and verdict.md of a comparison, from the folder alone. Ends the program by
/// CLI::RuntimeError: 1 for an invalid run, 3 for views without a score, 130 if it was interrupted.
void conclude(const experiment::RunOutcome& outcome, const std::filesystem::path& folder);

/// Writes verdict.md of a comparison from the tables in its folder; nothing for another run.
void write_verdict(const std::filesystem::path& folder);

}  // namespace ink::cli
