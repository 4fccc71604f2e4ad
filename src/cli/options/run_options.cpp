#include "cli/options/run_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include "cli/run_result.h"
#include "cli/run_status.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "experiment/experiment_plan.h"
#include "experiment/experiment_run.h"

namespace ink::cli {
namespace {

constexpr const char* kGoesOn = "the same command goes on";

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
    add_out_folder_option(command, options.out, "Folder of the run");
    command.add_option("--shard", options.shard, "Only this share; see inkbench merge")
        ->type_name("I/N")
        ->capture_default_str();
    command.add_flag(
        "--force", options.is_forced, "Throw away the run that is in the folder, whatever it is");
    command.add_flag("--no-times",
                     options.no_times,
                     "Leave columns of times empty: the same bytes on every run");
    command
        .add_option("--lanes",
                    options.lanes,
                    "Scenes worked on at a time, at most; one is timed at a time, and the others "
                    "stand still meanwhile where they would disturb it (default: one per core)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    command.add_flag("--dry-run", options.is_dry, "List the blocks and what they may take");
    command.add_flag("--status",
                     options.is_status,
                     "Say how far the run has come, with its shares in DIR.parts/I-of-N");
    add_quiet_option(command);
    command.add_flag("--json", options.is_json, "Print the result as JSON");
}

experiment::KeptImages kept_images(const std::string& word) {
    constexpr std::array<std::string_view, 3> kWords = {"none", "first", "all"};
    const auto found = std::find(kWords.begin(), kWords.end(), word);
    if (found == kWords.end()) {
        throw core::Error("--images", fmt::format("'{}' is no choice", word), "none | first | all");
    }
    return static_cast<experiment::KeptImages>(found - kWords.begin());
}

std::string run_command_text(const CLI::App& command) {
    return recorded_command(
        command, {"--out", "--shard", "--force", "--json", "--dry-run", "--status", "--lanes"});
}

void run_to_end(experiment::Experiment experiment,
                const RunFolderOptions& options,
                const CacheOptions& cache) {
    if (options.no_times) experiment.times = false;
    experiment::RunOptions run;
    run.shard = experiment::parse_shard(options.shard);
    run.out = options.out.empty() ? std::filesystem::path("inkbench-out") / experiment.name
                                  : std::filesystem::path(options.out);
    run.is_forced = options.is_forced;
    run.lanes = options.lanes;
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
    const core::InterruptGuard guard(kGoesOn);
    const experiment::RunOutcome outcome = run_experiment(plan, run);
    if (run.shard.is_all()) {
        conclude(outcome, run.out, options.is_json);
        return;
    }
    if (outcome.is_interrupted) end_interrupted(kGoesOn);
    fmt::print("shard {} is in {}: inkbench merge joins them\n", options.shard, run.out.string());
}

}  // namespace ink::cli
