#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/cell.h"
#include "harness/suite.h"
#include "harness/sweep.h"
#include "harness/tracing.h"
#include "statistics/ods.h"

namespace ink::experiment {

/// A comparison: methods x scenes x views.
struct CompareOptions {
    std::vector<harness::Entrant> entrants;
    harness::MeasureOptions measure;
    harness::SweepOptions sweep;
    harness::TraceOptions trace;
    bool study_scaling = false;  ///< also studies/scaling.h, on scenes of its own
    /// Directory: rows.csv, curves.csv, bins.csv, ladder.csv, sweep.csv, scaling.csv, skips.csv,
    /// motion.csv, roll.csv, vanishing.csv, cancellation.csv, summary.csv,
    /// verdict.md, report.html, figures.
    std::filesystem::path out;
    std::uint64_t seed = 0;     ///< of chance pictures and of drawing scenes again
    bool skip_study = false;    ///< measure too what each skip is worth
    bool study_motion = false;  ///< also studies/motion_study.h and the cube roll
    std::string command;        ///< as the user typed it, for the report
};

/// What came of a comparison.
struct CompareResult {
    std::vector<harness::Row> rows;
    std::vector<statistics::CellCurve> curves;  ///< of the methods' cells
    std::vector<harness::Row> sweep;            ///< a row per setting, method and swept view
    std::filesystem::path report;               ///< the page that was written
    bool is_interrupted = false;                ///< Ctrl-C: what was finished is there
    std::vector<std::string> void_reasons;      ///< brackets not as they must be, skips that show
};

/// Draws, traces, scores and times every cell, and writes the results to `options.out`.
///
/// For each view the bracket rows come first: `none` (F = 0 where there is truth), `oracle` (the
/// stored truth itself, F = 1) and `sampled`. The sweeps of the methods follow on the first views
/// of each scene; their rows have the columns of rows.csv and a file of their own, so that rows.csv
/// stays one row per method and view. When all are there, both files are written again with the
/// times that the cost model predicts (experiment/cost_model.h). A cell that fails is a row with
/// its status. Rows are on disk as soon as their view is finished. Throws core::Error if `out`
/// cannot be written, before any work.
[[nodiscard]] CompareResult compare(const std::vector<harness::Subject>& subjects,
                                    const CompareOptions& options);

}  // namespace ink::experiment
