#include "cli/options/run_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include "cli/options/command_rows.h"
#include "cli/options/method_options.h"
#include "cli/place.h"
#include "cli/run_result.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "experiment/block_store.h"
#include "experiment/experiment_plan.h"
#include "experiment/experiment_run.h"
#include "experiment/run_record.h"
#include "methods/method_configs.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

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
