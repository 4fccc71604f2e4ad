#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "cli/commands/commands.h"
#include "cli/options/method_options.h"
#include "cli/options/options.h"
#include "cli/options/run_options.h"
#include "cli/options/scene_options.h"
#include "core/error.h"
#include "experiment/experiment.h"

namespace ink::cli {
namespace {

constexpr int kMostViews = 360;

struct RunArgs {
    std::string file;
    SceneOptions scenes;
    std::vector<std::string> methods;
    std::string size;
    std::string views;
    RunFolderOptions folder;
    CacheOptions cache;
};

experiment::Experiment experiment_of(const RunArgs& args) {
    experiment::ExperimentOverrides overrides;
    overrides.size = args.size;
    overrides.scenes = fmt::format("{}", fmt::join(scene_names(args.scenes), ","));
    overrides.methods = method_list(args.methods);
    if (!args.views.empty()) {
        ViewOptions views;
        views.views = args.views;
        const auto count = view_request(views).orbit_count;
        if (!count) throw core::Error("--views", "no number", fmt::format("1..{}", kMostViews));
        overrides.views = count;
    }
    return with_overrides(experiment::read_experiment(args.file), overrides);
}

}  // namespace

void add_run_command(CLI::App& app) {
    auto args = std::make_shared<RunArgs>();
    auto* command = app.add_subcommand(
        "run", "Compute an experiment from its file; a run that was killed goes on where it was");
    command->add_option("file", args->file, "An experiment, such as experiments/quality.toml")
        ->type_name("FILE")
        ->required();
    add_run_folder_options(*command, args->folder);
    command->add_option("--size", args->size, "Image size instead of the file's sizes")
        ->type_name("WIDTHxHEIGHT");
    add_scene_options(*command, args->scenes, "Scenes instead of the file's");
    add_method_options(*command, args->methods, "the file's");
    command->add_option("--views", args->views, "Views of each scene, the first N")->type_name("N");
    add_cache_options(*command, args->cache);
    command->footer(
        "The folder is inkbench-out/NAME, or that of --out.\n"
        "Example: inkbench run experiments/smoke.toml --size 320x180\n"
        "Exit codes: 0 done, 1 the run is invalid or nothing has a score, 2 bad input or disk "
        "full, " +
        std::string(kUnscoredCode) + ", 130 interrupted.");
    command->callback([args, command] {
        experiment::Experiment experiment = experiment_of(*args);
        experiment.command = run_command_text(*command);
        run_to_end(experiment, args->folder, args->cache);
    });
}

}  // namespace ink::cli
