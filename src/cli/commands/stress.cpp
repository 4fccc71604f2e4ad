#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/name_list.h"
#include "cli/options/method_options.h"
#include "cli/options/options.h"
#include "cli/options/run_options.h"
#include "core/error.h"
#include "studies/stress/stress_axes.h"

namespace ink::cli {
namespace {

struct StressArgs {
    std::vector<std::string> axes;
    std::vector<std::string> methods;
    std::vector<std::string> settings;
    int points = 0;
    ViewOptions views;
    int threads = 1;
    std::string seed = "0";
    TruthSettings truth;  ///< its intersections alone
    CacheOptions cache;
    RunFolderOptions folder{.out = "inkbench-out/stress"};
};

std::vector<std::string> chosen_axes(const std::vector<std::string>& texts) {
    Names names{"--axes", "axis", {}};
    for (const studies::StressAxis& axis : studies::stress_axes())
        names.known.push_back(axis.name);
    std::vector<std::string> axes;
    for (const std::string& name : listed_names(texts, names)) {
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
    const std::string methods = method_list(args.methods);
    for (const harness::MethodConfig& config : harness::make_configs(methods, args.settings))
        if (!methods.empty()) experiment.methods.push_back(config.info->name);
    experiment.settings = args.settings;
    experiment.threads = {checked_threads(args.threads)};
    apply(args.truth, experiment);
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
    add_repeatable_option(*command,
                          "--axes,--axis",
                          args->axes,
                          "Axes a,b or globs (default: all; see inkbench list axes)",
                          "AXES");
    add_method_options(*command, args->methods);
    add_set_option(*command, args->settings);
    command->add_option("--points", args->points, "Points of an axis at most (default: all)");
    command->add_option("--size", args->views.size, "Size of an image")->capture_default_str();
    add_threads_option(*command, args->threads, "Threads of a method");
    add_seed_option(*command, args->seed, "Of the intervals");
    add_intersections_option(*command, args->truth.intersections);
    add_cache_options(*command, args->cache);
    add_run_folder_options(*command, args->folder);
    command->footer(
        "Writes rows.csv, stress.csv, stress_summary.csv, stress_axes.csv and report.html.\n"
        "Example: inkbench stress --axes grazing,origin --methods mote4,decaudin\n"
        "Exit codes: 0 done; 1 a number was not finite, a code overflowed, a cell has no result or "
        "images differ that must not; 2 bad input; 130 interrupted.");
    command->callback([args, command] {
        experiment::Experiment experiment = experiment_of(*args);
        experiment.command = run_command_text(*command);
        run_to_end(experiment, args->folder, args->cache);
    });
}

}  // namespace ink::cli
