#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/run_options.h"
#include "core/error.h"

namespace ink::cli {
namespace {

struct BoundArgs {
    std::vector<std::string> models;
    std::string scenes;
    std::string method = "mote4";
    std::vector<std::string> settings;
    ViewOptions views;
    TruthSettings truth;
    CacheOptions cache;
    experiment::BoundRequest bound;
    int threads = 1;
    RunFolderOptions folder{.out = "inkbench-out/bound"};
};

void check(const experiment::BoundRequest& bound) {
    if (bound.least_threshold < 0 || bound.least_threshold > 4 * 65535) {
        throw core::Error("--least-threshold",
                          fmt::format("{} codes are not possible", bound.least_threshold),
                          "0..262140");
    }
    if (!(bound.gap >= 0 && bound.gap <= 1)) {
        throw core::Error("--gap", fmt::format("{:g} is not possible", bound.gap), "0..1");
    }
    if (bound.boxes < 1) {
        throw core::Error("--boxes", fmt::format("{} is not possible", bound.boxes), "1 or more");
    }
}

experiment::Experiment experiment_of(const BoundArgs& args) {
    experiment::Experiment experiment;
    experiment.where = "inkbench bound";
    experiment.name = "bound";
    experiment.kind = experiment::ExperimentKind::bound;
    const auto entrants = harness::make_entrants(args.method, args.settings);
    if (entrants.size() != 1) {
        throw core::Error("--method", fmt::format("'{}' is not one method", args.method), "mote4");
    }
    experiment.methods = {entrants.front().info->name};
    experiment.settings = args.settings;
    check(args.bound);
    experiment.bound = args.bound;
    experiment.scenes = scene_names(args.scenes, args.models);
    if (experiment.scenes.empty()) experiment.scenes = experiment::scenes_called("catalogue");
    experiment.view_request = view_request(args.views);
    experiment.sizes = {{experiment.view_request.width_px, experiment.view_request.height_px}};
    experiment.threads = {checked_threads(args.threads)};
    truth::TruthOptions checked_truth;
    apply(args.truth, checked_truth);
    experiment.crease_deg = args.truth.crease_deg;
    experiment.weld_epsilon = args.truth.weld_epsilon;
    return experiment;
}

}  // namespace

void add_bound_command(CLI::App& app) {
    auto args = std::make_shared<BoundArgs>();
    auto* command = app.add_subcommand(
        "bound", "Bound from above what any four weights of a packed code could score");
    command->add_option("models", args->models, "Model files, or built-in scenes");
    command->add_option("--scenes", args->scenes, "Scenes a,b (default: the whole catalogue)");
    command->add_option("--method,--methods", args->method, "A method whose code is a linear sum")
        ->capture_default_str();
    add_set_option(*command, args->settings);
    command->add_flag("--signed", args->bound.is_signed, "Weights below 0 too");
    command
        ->add_option("--least-threshold",
                     args->bound.least_threshold,
                     "Least threshold in codes (0: the least that the filter draws)")
        ->capture_default_str();
    command->add_option("--gap", args->bound.gap, "Stop where upper and found are this close")
        ->capture_default_str();
    command->add_option("--boxes", args->bound.boxes, "Stop after this many boxes of weights")
        ->capture_default_str();
    add_view_options(*command, args->views);
    add_truth_settings(*command, args->truth);
    add_cache_options(*command, args->cache);
    command->add_option("--threads", args->threads, "Threads")->capture_default_str();
    add_run_folder_options(*command, args->folder);
    command->footer(
        "F upper: no weights can exceed it. F found: reached by some weights. F: the method's own "
        "score. F model: its weights scored by the bound's more lenient rule.\n"
        "Example: inkbench bound torus gem --method mote4 --size 640x360\n"
        "Exit codes: 0 done, 2 bad input, 130 interrupted.");
    command->callback([args, command] {
        experiment::Experiment experiment = experiment_of(*args);
        experiment.command = command_line(*command);
        run_to_end(experiment, args->folder, args->cache);
    });
}

}  // namespace ink::cli
