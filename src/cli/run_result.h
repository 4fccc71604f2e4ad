#pragma once

#include <filesystem>

#include "experiment/experiment_run.h"
#include "experiment/run_data.h"

namespace ink::cli {

/// Shows what came of a run in `folder`: the verdict and the best settings, or the counts of
/// stress; every view without a score with its reason and a remedy; where page and tables are. With
/// `is_json` one JSON object on stdout instead of tables for people.
///
/// Writes report.html, verdict.md and figures (or stress.html) from the folder alone. Ends the
/// program by CLI::RuntimeError: 1 for an invalid run, 3 for views without a score, 130 if it was
/// interrupted.
void conclude(const experiment::RunOutcome& outcome,
              const std::filesystem::path& folder,
              bool is_json);

/// Writes the page of the run in `folder` to `page`, or to the folder's own place if that is empty.
/// Returns where it is. Throws core::Error for a run that has no page.
std::filesystem::path write_page(experiment::RunData run,
                                 const std::filesystem::path& folder,
                                 const std::filesystem::path& page);

}  // namespace ink::cli
