#include <fmt/format.h>

#include <memory>

#include "cli/commands/commands.h"
#include "cli/options/experiment_options.h"
#include "cli/options/method_options.h"
#include "cli/options/options.h"
#include "cli/options/run_options.h"
#include "cli/options/scene_options.h"

namespace ink::cli {
namespace {

constexpr const char* kMethod = "mote4";  // unless one is named

experiment::Experiment experiment_of(MeasureArgs& args) {
    args.methods = {one_method(args.methods, kMethod)};
    experiment::Experiment experiment = args.read();
    if (experiment.scenes.empty()) experiment.scenes = experiment::scenes_called("catalogue");
    return experiment;
}

}  // namespace

void add_bound_command(CLI::App& app) {
    auto args = std::make_shared<MeasureArgs>("bound", "inkbench-out/bound");
    args->options.usual().kind = experiment::ExperimentKind::bound;
    auto* command = app.add_subcommand(
        "bound", "Estimate the best score that any four weights of a packed code could have");
    add_scene_options(
        *command, args->scenes, "Built-in scenes or model files (default: the catalogue)");
    add_method_options(
        *command, args->methods, fmt::format("{}; one whose code is a linear sum", kMethod));
    add_set_option(*command, args->settings);
    ExperimentOptions& options = args->options;
    options.add_to(*command, {"bound.signed", "bound.least_threshold", "bound.gap", "bound.boxes"});
    add_view_options(*command, args->views);
    options.add_to(*command, truth_rows());
    add_cache_options(*command, args->cache);
    options.add_to(*command, {"grid.threads"}, "Threads that search and trace");
    add_run_folder_options(*command, args->folder);
    command->footer(
        "F upper: no weights can exceed it. F found: reached by some weights. F: the method's own "
        "score. F model: its weights scored by the bound's more lenient rule.\n"
        "Example: inkbench bound torus gem --method mote4 --size 640x360\n"
        "Exit codes: 0 done, 2 bad input, 130 interrupted.");
    command->callback(
        [args, command] { run_to_end(*command, experiment_of(*args), args->folder, args->cache); });
}

}  // namespace ink::cli
