#include "cli/options/run_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/place.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "core/whole_file.h"
#include "experiment/block_store.h"
#include "experiment/experiment_plan.h"
#include "experiment/experiment_run.h"
#include "experiment/run_data.h"
#include "experiment/run_record.h"
#include "harness/clock/timing.h"
#include "methods/method_configs.h"
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

/// "3-of-16" as 3 and 16.
std::optional<std::pair<int, int>> share_of(const std::string& name) {
    int i = 0;
    int n = 0;
    int used = 0;
    if (std::sscanf(name.c_str(), "%d-of-%d%n", &i, &n, &used) != 2) return std::nullopt;
    if (used != static_cast<int>(name.size()) || i < 1 || i > n) return std::nullopt;
    return std::pair(i, n);
}

/// The shares beside a run, in the order of their numbers.
std::map<std::pair<int, int>, fs::path> shares_beside(const fs::path& out) {
    std::map<std::pair<int, int>, fs::path> shares;
    std::error_code failure;
    for (const auto& entry : fs::directory_iterator(out.string() + ".parts", failure)) {
        const auto share = share_of(entry.path().filename().string());
        if (share) shares.emplace(*share, entry.path());
    }
    return shares;
}

/// What a folder has done of a plan.
struct Progress {
    std::set<std::size_t> done;
    bool is_finished = false;
    std::string problem = {};  ///< why its blocks do not count, or ""
};

Progress progress_of(const experiment::Plan& plan, const fs::path& folder) {
    Progress progress;
    const auto record = experiment::read_record(folder);
    if (!record) return progress;
    if (record->identity != plan.identity) {
        progress.problem =
            fmt::format("holds another run ('{}' by build {})", record->name, record->build);
        return progress;
    }
    progress.is_finished = record->state != experiment::RunState::unfinished;
    for (const std::size_t block : experiment::BlockStore(folder).indices())
        progress.done.insert(block);
    return progress;
}

/// How far a run has come, for a terminal: blocks done of all, in its folder `out` and in the
/// shares beside it, `out`.parts/I-of-N, each with the blocks that it is to do. A folder that is
/// not there has none; one of another experiment or build is named and does not count.
std::string run_status(const experiment::Plan& plan, const fs::path& out) {
    const std::size_t all = plan.blocks.size();
    const Progress whole = progress_of(plan, out);
    if (whole.is_finished)
        return fmt::format("{}: finished, {} blocks in {}\n", plan.name, all, out.string());
    std::set<std::size_t> done = whole.done;
    std::string lines;
    if (!whole.problem.empty()) lines += fmt::format("  {} {}\n", out.string(), whole.problem);
    for (const auto& [share, folder] : shares_beside(out)) {
        const Progress part = progress_of(plan, folder);
        const std::size_t asked = experiment::shard_blocks(plan, share.first, share.second).size();
        done.insert(part.done.begin(), part.done.end());
        lines += fmt::format("  {}: {}\n",
                             folder.string(),
                             part.problem.empty()
                                 ? fmt::format("{} of {} blocks", part.done.size(), asked)
                                 : part.problem);
    }
    return fmt::format("{}: {} of {} blocks are done\n", plan.name, done.size(), all) + lines;
}

constexpr const char* kGoesOn = "the same command goes on";

/// Says of which scenes views by name have another axis up than y.
void say_up(const experiment::Experiment& experiment) {
    if (experiment.view_request.directions.empty()) return;
    for (const std::string& scene : experiment.scenes)
        print_up(scene, harness::up_of(experiment.view_request, scene));
}

/// At once, also into a pipe: whoever waits wants to know how long.
void say(const std::string& line) {
    fmt::print(stderr, "{}\n", line);
    std::fflush(stderr);
}

void list_blocks(const experiment::Plan& plan, const experiment::Shard& shard) {
    double work_s = 0;
    for (const std::size_t i : experiment::shard_blocks(plan, shard.i, shard.n)) {
        fmt::print("{:6} cells  {:8.1f} s  {}\n",
                   plan.blocks[i].cells,
                   plan.blocks[i].work,
                   plan.blocks[i].key);
        work_s += plan.blocks[i].work;
    }
    fmt::print("{}: {} cells in {} blocks, about {:.0f} s on two idle cores\n",
               plan.name,
               plan.cells(),
               plan.blocks.size(),
               work_s);
}

/// Writes verdict.md of a comparison from the tables in its folder; nothing for another run.
void write_verdict(const fs::path& folder) {
    experiment::RunData run = experiment::read_run(folder);
    run.tables.rows = experiment::rows_of_one_place(std::move(run.tables.rows));
    write_verdict_of(run);
}

}  // namespace

void conclude(const experiment::RunOutcome& outcome, const fs::path& folder) {
    experiment::RunData run = experiment::read_run(folder);
    const fs::path page = folder / "report.html";
    report::write_run_page({run}, page);
    // Of every size and number of threads, before one of them is kept to be printed.
    const UnscoredCells unscored = summary::unscored_cells(run.tables.rows);
    const bool is_without_score =
        run.record.missing_blocks.empty() && summary::is_all_unscored(run.tables.rows);
    const std::string busy = harness::uncertain_times(run.tables.rows);
    run.tables.rows = experiment::rows_of_one_place(std::move(run.tables.rows));
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

void add_run_folder_options(CLI::App& command, RunFolderOptions& options) {
    CommandRows rows(command);
    // clang-format off
    add_out_folder_option(command, options.out,
                          "Folder of the run" +
                              std::string(options.out.empty() ? " (default: inkbench-out/NAME)" : ""));
    rows.text("--shard", options.shard, "I/N", "Only this share; see inkbench merge");
    rows.flag("--force", options.is_forced,
              "Throw away the run that is in the folder, whatever it is");
    rows.flag("--no-times", options.no_times,
              "Leave columns of times empty: the same bytes on every run");
    rows.number("--lanes", options.lanes, {1, 1024}, "N",
                "Scenes worked on at a time, at most; one where a timed loop does not bear "
                "neighbours (default: one per core)");
    rows.flag("--dry-run", options.is_dry, "List the blocks and what they may take");
    rows.flag("--status", options.is_status,
              "Say how far the run has come, with its shares in DIR.parts/I-of-N");
    add_quiet_option(command);
    // clang-format on
}

MeasureArgs::MeasureArgs(const std::string& name, const std::string& out) {
    options.usual().where = name;
    options.usual().name = name;
    folder.out = out;
}

experiment::Experiment MeasureArgs::read() const {
    experiment::Experiment experiment = options.read();
    const std::string names = method_list(methods);
    for (const method::MethodConfig& config :
         methods::make_configs(names, settings, experiment.compare.presets))
        if (!names.empty() && !config.owned) experiment.methods.push_back(config.info->name);
    cover_named_ink(experiment);
    experiment.settings = settings;
    experiment.scenes = scene_names(scenes);
    return experiment;
}

void run_to_end(const CLI::App& command,
                experiment::Experiment experiment,
                const RunFolderOptions& options,
                const CacheOptions& cache) {
    if (experiment.command.empty()) {
        experiment.command = recorded_command(
            command, {"--out", "--shard", "--force", "--dry-run", "--status", "--lanes"});
    }
    if (options.no_times) experiment.times = false;
    experiment::RunOptions run;
    run.shard = experiment::parse_shard(options.shard);
    run.out = options.out.empty() ? std::filesystem::path("inkbench-out") / experiment.name
                                  : std::filesystem::path(options.out);
    run.is_forced = options.is_forced;
    run.lanes = options.lanes.value_or(0);
    run.cut_off = [&] { write_verdict(run.out); };
    if (!core::progress_display().is_quiet) run.say = say;
    const experiment::Plan plan = make_plan(experiment, cache_folder(cache));
    if (options.is_dry) {
        list_blocks(plan, run.shard);
        return;
    }
    if (options.is_status) {
        fmt::print("{}", run_status(plan, run.out));
        return;
    }
    say_up(experiment);
    const core::InterruptGuard guard(kGoesOn);
    const experiment::RunOutcome outcome = run_experiment(plan, run);
    if (run.shard.is_all()) {
        conclude(outcome, run.out);
        return;
    }
    if (outcome.is_interrupted) end_interrupted(kGoesOn);
    fmt::print("shard {} is in {}: inkbench merge joins them\n", options.shard, run.out.string());
}

}  // namespace ink::cli
