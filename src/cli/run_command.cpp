#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/options.h"
#include "core/error.h"
#include "experiment/experiment.h"
#include "experiment/experiment_plan.h"
#include "experiment/experiment_run.h"

namespace ink::cli {
namespace {

constexpr int kMostViews = 360;

struct RunArgs {
    std::string file;
    std::string out;
    std::string shard = "1/1";
    experiment::ExperimentOverrides overrides;
    std::string views;
    bool is_fresh = false;
    bool is_dry = false;
    CacheOptions cache;
};

/// At once, also into a pipe: whoever waits wants to know how long.
void say(const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
}

experiment::Experiment experiment_of(const RunArgs& args) {
    experiment::ExperimentOverrides overrides = args.overrides;
    if (!args.views.empty()) {
        ViewOptions views;
        views.views = args.views;
        const auto count = view_request(views).orbit_count;
        if (!count) throw core::Error("--views", "no number", fmt::format("1..{}", kMostViews));
        overrides.views = count;
    }
    return with_overrides(experiment::read_experiment(args.file), overrides);
}

void list_blocks(const experiment::Plan& plan, const experiment::Shard& shard) {
    for (const std::size_t i : experiment::shard_blocks(plan, shard.i, shard.n))
        say(fmt::format("{:6} cells  {}", plan.blocks[i].cells, plan.blocks[i].key));
    say(fmt::format("{}: {} cells in {} blocks", plan.name, plan.cells(), plan.blocks.size()));
}

void run_run(const RunArgs& args) {
    const experiment::Experiment experiment = experiment_of(args);
    harness::TraceOptions trace;
    trace.cache = cache_folder(args.cache);
    const experiment::Plan plan = make_plan(experiment, trace);
    experiment::RunOptions options;
    options.shard = experiment::parse_shard(args.shard);
    options.out = args.out.empty() ? std::filesystem::path("inkbench-out") / experiment.name
                                   : std::filesystem::path(args.out);
    options.is_fresh = args.is_fresh;
    options.say = say;
    if (args.is_dry) {
        list_blocks(plan, options.shard);
        return;
    }
    const experiment::RunOutcome outcome = run_experiment(plan, options);
    for (const std::filesystem::path& table : outcome.tables)
        say(table.string());
    for (const std::string& fault : outcome.faults)
        fmt::print(stderr, "inkbench: this run is void: {}\n", fault);
    if (outcome.is_interrupted) {
        fmt::print(stderr,
                   "inkbench: interrupted; what is finished is in {}, the same command goes on\n",
                   options.out.string());
        throw CLI::RuntimeError(kInterrupted);
    }
    if (!outcome.faults.empty()) throw CLI::RuntimeError(1);
    if (!options.shard.is_all()) {
        say(fmt::format(
            "shard {} is in {}: inkbench merge joins them", args.shard, options.out.string()));
    }
}

}  // namespace

void add_run_command(CLI::App& app) {
    auto args = std::make_shared<RunArgs>();
    auto* command = app.add_subcommand(
        "run", "Compute an experiment from its file; a run that was killed goes on where it was");
    command->add_option("file", args->file, "An experiment, such as experiments/quality.toml")
        ->required();
    command->add_option("--out", args->out, "Folder of the tables (inkbench-out/NAME)");
    command->add_option("--shard", args->shard, "i/n: only this share; see inkbench merge")
        ->capture_default_str();
    command->add_option("--size", args->overrides.size, "WIDTHxHEIGHT instead of the file's sizes");
    command->add_option("--scenes", args->overrides.scenes, "Scenes a,b instead of the file's");
    command->add_option("--methods", args->overrides.methods, "Methods a,b instead of the file's");
    command->add_option("--views", args->views, "Views of each scene, the first N");
    command->add_flag("--no-times",
                      args->overrides.no_times,
                      "Leave columns of times empty: the same bytes on every run");
    command->add_flag(
        "--fresh", args->is_fresh, "Throw away what an earlier run left in the folder");
    command->add_flag("--dry-run", args->is_dry, "List the blocks and how many cells they have");
    add_cache_options(*command, args->cache);
    command->footer(
        "Example: inkbench run experiments/smoke.toml --size 320x180\n"
        "Exit codes: 0 done, 1 the run is void, 2 bad input or disk full, 130 interrupted.");
    command->callback([args] { run_run(*args); });
}

}  // namespace ink::cli
