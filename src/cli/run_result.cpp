#include "cli/run_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/json_values.h"
#include "cli/options/options.h"
#include "cli/place.h"
#include "core/interrupt.h"
#include "core/whole_file.h"
#include "experiment/run_data.h"
#include "harness/clock/timing.h"
#include "report/run_page.h"
#include "report/text/verdict.h"
#include "studies/axis_summary.h"
#include "studies/hardest/hardest_table.h"
#include "summary/summary_csv.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kInvalid = 1;  ///< also where no cell has a score
constexpr int kUnscored = 3;

nlohmann::json methods_json(const std::vector<summary::MethodSummary>& summaries) {
    return list_of(summaries, [](const summary::MethodSummary& s) -> nlohmann::json {
        nlohmann::json method = {{"method", s.method},
                                 {"views", s.views},
                                 {"failed", s.failed},
                                 {"f_2px", or_null(s.f.all)},
                                 {"f_train", or_null(s.f.train)},
                                 {"f_heldout", or_null(s.f.heldout)},
                                 {"f_real", or_null(s.f.real)},
                                 {"f_1px", or_null(s.f_1px)},
                                 {"precision_2px", or_null(s.precision)},
                                 {"recall_2px", or_null(s.recall)},
                                 {"draw_ms", or_null(s.draw_ms)}};
        if (s.soft_f.all) method["soft_f"] = *s.soft_f.all;
        return method;
    });
}

nlohmann::json answer_json(const summary::Comparison& comparison) {
    const summary::Answer answer = comparison.answer();
    const auto name_of = [](const summary::MethodSummary* s) {
        return s == nullptr ? nlohmann::json(nullptr) : nlohmann::json(s->method);
    };
    return {{"method", name_of(answer.method)},
            {"most_exact", name_of(answer.most_exact)},
            {"measure", summary::name(comparison.measure())},
            {"f_margin", comparison.rule.f_margin},
            {"budget_ms", comparison.rule.budget_ms}};
}

using UnscoredCells = std::vector<summary::Unscored>;

nlohmann::json unscored_json(const UnscoredCells& cells) {
    return list_of(cells, [](const summary::Unscored& cell) -> nlohmann::json {
        return {{"scene", cell.scene},
                {"view", cell.view},
                {"method", cell.method},
                {"reason", cell.reason},
                {"remedy", cell.remedy}};
    });
}

nlohmann::json result_json(const experiment::RunData& run,
                           const UnscoredCells& unscored,
                           const fs::path& page) {
    const experiment::RunRecord& record = run.record;
    return {{"run", run.folder.string()},
            {"kind", record.kind},
            {"state", experiment::name(record.state)},
            {"page", page.string()},
            {"methods", methods_json(run.comparison.summaries)},
            {"answer", answer_json(run.comparison)},
            {"unscored", unscored_json(unscored)},
            {"missing", record.missing_blocks},
            {"faults", record.faults}};
}

report::Missing missing_of(const experiment::RunRecord& record) {
    return {static_cast<int>(record.missing_blocks.size()), record.blocks};
}

/// A run of views that were chosen because they are bad is no comparison.
bool is_comparison(const experiment::RunData& run) {
    return !run.tables.rows.empty() && run.tables.hardest.empty();
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

/// How many times of the comparison and of all studies are uncertain; "" if none are.
std::string busy_text(const experiment::RunTables& tables) {
    std::vector<harness::Row> rows = tables.rows;
    for (const studies::AxisRow& of : tables.on_axes)
        rows.push_back(of.row);
    return harness::uncertain_times(rows);
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
    if (!is_comparison(run)) return;
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

void conclude(const experiment::RunOutcome& outcome, const fs::path& folder, bool is_json) {
    experiment::RunData run = experiment::read_run(folder);
    const fs::path page = folder / "report.html";
    report::write_run_page({run}, page);
    // Of every size and number of threads, before one of them is kept to be printed.
    const UnscoredCells unscored = summary::unscored_cells(run.tables.rows);
    const bool is_without_score =
        run.record.missing_blocks.empty() && summary::is_all_unscored(run.tables.rows);
    const std::string busy = busy_text(run.tables);
    experiment::keep_one_place(run.tables);
    write_verdict_of(run);
    if (is_json) {
        fmt::print("{}\n", result_json(run, unscored, page).dump(2));
    } else {
        if (is_comparison(run)) print_comparison(run);
        fmt::print("{}", studies::hardest_text(run.tables.hardest));
        fmt::print("{}", studies::stress_table(studies::summarise_axes(run.tables.on_axes)));
        if (!run.finding.first.empty()) fmt::print("{}.\n", run.finding.first);
        fmt::print("run: {}\nreport: {}\n", folder.string(), page.string());
    }
    std::fflush(stdout);
    print_warnings(run.record, unscored, busy, folder);
    if (is_without_score) fmt::print(stderr, "inkbench: not one cell has a score\n");
    if (outcome.is_interrupted) throw CLI::RuntimeError(core::kInterrupted);
    if (is_without_score || !run.record.faults.empty()) throw CLI::RuntimeError(kInvalid);
    if (std::any_of(unscored.begin(), unscored.end(), summary::is_failure))
        throw CLI::RuntimeError(kUnscored);
}

}  // namespace ink::cli
