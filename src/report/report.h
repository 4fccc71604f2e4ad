#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/run_data.h"
#include "experiment/summary/cost_model.h"
#include "harness/row.h"
#include "harness/shown_view.h"
#include "linear_code/cancellation.h"
#include "statistics/ods.h"
#include "studies/motion_rows.h"
#include "studies/roll_study.h"
#include "studies/scaling.h"
#include "studies/skip_study.h"

namespace ink::report {

/// Everything a report says.
struct ReportData {
    std::string command;  ///< how it was made, as the user typed it
    std::vector<harness::Row> rows;
    std::vector<harness::ShownView> views;  ///< one per scene, to keep the page under 20 MB
    double elapsed_s = 0;
    std::vector<statistics::CellCurve> curves =
        {};  ///< of the methods' cells: what ODS, OIS and AP come from
    std::vector<harness::Row> sweep = {};  ///< a row per setting, method and swept view
    experiment::CostFit cost_fit = {};     ///< what the rows' predicted times were made from
    std::vector<studies::ScalingPoint> scaling = {};  ///< how times grow, if that was asked for
    std::vector<studies::SkipTime> skip_study = {};   ///< what skips are worth, if that was asked
    std::vector<studies::MotionRow> motion = {};      ///< of sequences, if that was asked
    std::vector<studies::RollCurve> rolls = {};       ///< of the cube roll, with them
    std::vector<linear_code::CancellationRow> cancellation =
        {};                                        ///< of methods that declare a code
    std::vector<std::string> missing_blocks = {};  ///< blocks of the run that are not there
    int blocks = 0;                                ///< of the whole run
    std::vector<std::string> faults = {};          ///< why the run is invalid
};

/// What a page says of a run. A run over several sizes or numbers of threads is shown at its first.
[[nodiscard]] ReportData report_data(experiment::RunData run);

/// Writes a self-contained page: verdict table, error against time, per-class bars, truth and
/// method side by side with the errors in colour, every row, provenance. No file beside it, no
/// network.
///
/// Written beside `path` and renamed, so a reader never sees half a page. Throws core::Error if it
/// cannot be written.
void write_report(const ReportData& data, const std::filesystem::path& path);

}  // namespace ink::report
