#include <fmt/format.h>

#include <memory>

#include "cli/commands/commands.h"
#include "cli/options/method_options.h"
#include "cli/options/options.h"
#include "cli/options/run_options.h"
#include "cli/options/scene_options.h"
#include "core/error.h"

namespace ink::cli {
namespace {

constexpr const char* kMethod = "mote4";  // unless one is named

struct BoundArgs {
    SceneOptions scenes;
    std::vector<std::string> methods;
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
    const std::string method = one_method(args.methods, kMethod);
    (void)harness::make_configs(method, args.settings);  // refuses settings that it does not know
    experiment.methods = {method};
    experiment.settings = args.settings;
    check(args.bound);
    experiment.bound = args.bound;
    experiment.scenes = scene_names(args.scenes);
    if (experiment.scenes.empty()) experiment.scenes = experiment::scenes_called("catalogue");
    experiment.view_request = view_request(args.views);
    experiment.sizes = {{experiment.view_request.width_px, experiment.view_request.height_px}};
    experiment.threads = {checked_threads(args.threads)};
    apply(args.truth, experiment);
    return experiment;
}

}  // namespace

void add_bound_command(CLI::App& app) {
    auto args = std::make_shared<BoundArgs>();
    auto* command = app.add_subcommand(
        "bound", "Estimate the best score that any four weights of a packed code could have");
    add_scene_options(
        *command, args->scenes, "Built-in scenes or model files (default: the catalogue)");
    add_method_options(
        *command, args->methods, fmt::format("{}; one whose code is a linear sum", kMethod));
    add_set_option(*command, args->settings);
    command->add_flag("--signed", args->bound.is_signed, "Allow negative weights");
    command
        ->add_option("--least-threshold",
                     args->bound.least_threshold,
                     "Least threshold in codes (0: the least that the filter draws)")
        ->capture_default_str();
    command->add_option("--gap", args->bound.gap, "Stop when upper and found are this close")
        ->capture_default_str();
    command->add_option("--boxes", args->bound.boxes, "Stop after this many boxes of weights")
        ->capture_default_str();
    add_view_options(*command, args->views);
    add_truth_settings(*command, args->truth);
    add_cache_options(*command, args->cache);
    add_threads_option(*command, args->threads, "Threads that search and trace");
    add_run_folder_options(*command, args->folder);
    command->footer(
        "F upper: no weights can exceed it. F found: reached by some weights. F: the method's own "
        "score. F model: its weights scored by the bound's more lenient rule.\n"
        "Example: inkbench bound torus gem --method mote4 --size 640x360\n"
        "Exit codes: 0 done, 2 bad input, 130 interrupted.");
    command->callback([args, command] {
        experiment::Experiment experiment = experiment_of(*args);
        experiment.command = run_command_text(*command);
        run_to_end(experiment, args->folder, args->cache);
    });
}

}  // namespace ink::cli
