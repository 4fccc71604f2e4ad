#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiment/stress_summary.h"
#include "studies/stress/stress_axes.h"
#include "studies/stress/stress_rows.h"

namespace ink::experiment {

/// Methods x axes x values x cases.
struct StressOptions {
    std::vector<const studies::StressAxis*> axes;  ///< at least one
    int points = 1000;                             ///< of an axis at most, two at least
    std::vector<harness::Entrant> entrants;
    harness::MeasureOptions measure;
    harness::TraceOptions trace;
    studies::StressSize size;
    std::uint64_t seed = 0;  ///< of drawing cases again
    /// Directory: stress.csv, stress_summary.csv, stress.html, figures/stress_<axis>.svg.
    std::filesystem::path out;
    std::string command;  ///< as the user typed it, for the page
};

struct StressResult {
    std::vector<studies::StressRow> rows;
    std::vector<StressPointSummary> points;
    studies::StressCounts counts;  ///< over all rows: all must be 0
    std::filesystem::path page;
    bool is_interrupted = false;  ///< Ctrl-C: what was finished is there
};

/// Runs every case of the axes and writes rows, summary, a figure per axis and the page.
///
/// Rows are on disk as soon as their case is finished. They hold no times: the same bytes for every
/// number of threads. Throws core::Error if `out` cannot be written, before any work.
[[nodiscard]] StressResult run_stress(const StressOptions& options);

}  // namespace ink::experiment
