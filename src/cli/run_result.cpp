#include "cli/run_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "cli/options/options.h"
#include "cli/place.h"
#include "core/interrupt.h"
#include "core/whole_file.h"
#include "experiment/run_data.h"
#include "harness/clock/timing.h"
#include "report/run_page.h"
#include "report/text/verdict.h"
#include "studies/axis_summary.h"
#include "summary/summary_csv.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kInvalid = 1;  ///< also where no cell has a score
constexpr int kUnscored = 3;

using UnscoredCells = std::vector<summary::Unscored>;

report::Missing missing_of(const experiment::RunRecord& record) {
    return {static_cast<int>(record.missing_blocks.size()), record.blocks};
}

void print_comparison(const experiment::RunData& run) {
    const std::vector<harness::Row>& rows = run.tables.rows;
    const harness::Row& first = rows.front();
    if (!run.record.one_place) {
        fmt::print(
            "At {}x{} px on {} thread(s); the other sizes and numbers of threads are in "
            "rows.csv.\n",
            first.width,
            first.height,
            first.threads);
    }
    fmt::print("{}\n", report::verdict_table(rows, run.comparison, missing_of(run.record)));
}

void print_warnings(const experiment::RunRecord& record,
                    const UnscoredCells& unscored,
                    const std::string& busy,
                    const fs::path& folder) {
    if (!busy.empty()) fmt::print(stderr, "inkbench: {}\n", busy);
    for (const experiment::ModelFacts& model : record.models)
        print_not_heeded(model.scene, model.notes);
    fmt::print(stderr, "{}", summary::unscored_text(unscored));
    for (const std::string& fault : record.faults)
        fmt::print(stderr, "inkbench: this run is invalid: {}\n", fault);
    if (record.missing_blocks.empty()) return;
    fmt::print(stderr,
               "inkbench: {} of {} parts are missing; what is finished is in {}, the same command "
               "goes on\n",
               record.missing_blocks.size(),
               record.blocks,
               folder.string());
}

/// verdict.md of a comparison of one size and number of threads.
void write_verdict_of(const experiment::RunData& run) {
    if (run.tables.rows.empty()) return;
    core::write_whole_file(
        run.folder / "verdict.md",
        report::verdict_markdown(run.tables.rows, run.comparison, missing_of(run.record)));
}

}  // namespace

void write_verdict(const fs::path& folder) {
    experiment::RunData run = experiment::read_run(folder);
    experiment::keep_one_place(run.tables);
    write_verdict_of(run);
}

void conclude(const experiment::RunOutcome& outcome, const fs::path& folder) {
    experiment::RunData run = experiment::read_run(folder);
    const fs::path page = folder / "report.html";
    report::write_run_page({run}, page);
    // Of every size and number of threads, before one of them is kept to be printed.
    const UnscoredCells unscored = summary::unscored_cells(run.tables.rows);
    const bool is_without_score =
        run.record.missing_blocks.empty() && summary::is_all_unscored(run.tables.rows);
    const std::string busy = harness::uncertain_times(run.tables.rows);
    experiment::keep_one_place(run.tables);
    write_verdict_of(run);
    if (!run.tables.rows.empty()) print_comparison(run);
    fmt::print("{}", studies::stress_table(studies::summarise_axes(run.tables.on_axes)));
    if (!run.finding.first.empty()) fmt::print("{}.\n", run.finding.first);
    fmt::print("run: {}\nreport: {}\n", folder.string(), page.string());
    std::fflush(stdout);
    print_warnings(run.record, unscored, busy, folder);
    if (is_without_score) fmt::print(stderr, "inkbench: not one cell has a score\n");
    if (outcome.is_interrupted) throw CLI::RuntimeError(core::kInterrupted);
    if (is_without_score || !run.record.faults.empty()) throw CLI::RuntimeError(kInvalid);
    if (std::any_of(unscored.begin(), unscored.end(), summary::is_failure))
        throw CLI::RuntimeError(kUnscored);
}

}  // namespace ink::cli
