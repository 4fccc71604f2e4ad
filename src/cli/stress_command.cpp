#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/run_options.h"
#include "core/error.h"
#include "studies/stress/stress_axes.h"

namespace ink::cli {
namespace {

struct StressArgs {
    std::string axes;
    std::string methods;
    std::vector<std::string> settings;
    int points = 0;
    ViewOptions views;
    int threads = 1;
    std::string seed = "0";
    CacheOptions cache;
    RunFolderOptions folder{.out = "inkbench-out/stress"};
};

std::vector<std::string> chosen_axes(const std::string& list) {
    std::vector<std::string> axes;
    for (const std::string& name : harness::split_list(list)) {
        (void)studies::find_stress_axis(name);
        if (std::find(axes.begin(), axes.end(), name) != axes.end())
            throw core::Error("--axes", fmt::format("'{}' is named twice", name), "each once");
        axes.push_back(name);
    }
    return axes;
}

experiment::Experiment experiment_of(const StressArgs& args) {
    experiment::Experiment experiment;
    experiment.where = "inkbench stress";
    experiment.name = "stress";
    experiment.kind = experiment::ExperimentKind::stress;
    experiment.axes = chosen_axes(args.axes);
    for (const harness::Entrant& entrant : harness::make_entrants(args.methods, args.settings))
        if (!args.methods.empty()) experiment.methods.push_back(entrant.info->name);
    experiment.settings = args.settings;
    experiment.threads = {checked_threads(args.threads)};
    experiment.seed = parse_seed(args.seed);
    if (args.points != 0 && (args.points < 2 || args.points > 1000)) {
        throw core::Error("--points", fmt::format("{} is not possible", args.points), "2..1000");
    }
    experiment.points = args.points;
    const harness::ViewRequest request = view_request(args.views);
    experiment.sizes = {{request.width_px, request.height_px}};
    return experiment;
}

}  // namespace

void add_stress_command(CLI::App& app) {
    auto args = std::make_shared<StressArgs>();
    args->views.size = "480x270";
    auto* command =
        app.add_subcommand("stress", "Sweep one difficulty at a time: error curves per method");
    command->add_option("--axes,--axis", args->axes, "Axes a,b (default: all; see list axes)");
    command->add_option("--methods,--method", args->methods, "Methods a,b (default: all)");
    add_set_option(*command, args->settings);
    command->add_option("--points", args->points, "Points of an axis at most (default: all)");
    command->add_option("--size", args->views.size, "Size of a picture")->capture_default_str();
    command->add_option("--threads", args->threads, "Threads of a method")->capture_default_str();
    command->add_option("--seed", args->seed, "Of the intervals")->capture_default_str();
    add_cache_options(*command, args->cache);
    add_run_folder_options(*command, args->folder);
    command->footer(
        "Writes rows.csv, stress.csv, stress_summary.csv, stress.html and "
        "figures/stress_<axis>.svg.\n"
        "Example: inkbench stress --axes grazing,origin --methods mote4,decaudin\n"
        "Exit codes: 0 done; 1 a number was not finite, a code overflowed, a cell was lost or "
        "pictures differ that must not; 2 bad input; 130 interrupted.");
    command->callback([args, command] {
        experiment::Experiment experiment = experiment_of(*args);
        experiment.command = command_line(*command);
        run_to_end(experiment, args->folder, args->cache);
    });
}

}  // namespace ink::cli
