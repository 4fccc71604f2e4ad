#include <memory>

#include "cli/commands/commands.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/options/run_options.h"
#include "core/split_list.h"
#include "experiment/options/option_table.h"

namespace ink::cli {
namespace {

struct RunArgs {
    std::string file;
    SceneOptions scenes;
    std::vector<std::string> methods;
    std::string size;
    std::string views;
    RunFolderOptions folder;
    CacheOptions cache;
};

/// The file's experiment with what the command line puts in place of its own.
experiment::Experiment experiment_of(const RunArgs& args) {
    experiment::Experiment experiment = experiment::read_experiment(args.file);
    const auto set =
        [&](const char* option, const char* flag, const std::vector<std::string>& texts) {
            std::vector<core::GivenText> given;
            for (const std::string& text : texts)
                given.push_back({text, flag});
            if (!given.empty()) experiment::set_option(experiment, option, given);
        };
    if (!args.size.empty()) set("grid.sizes", "--size", {args.size});
    set("grid.scenes", "--scenes", scene_names(args.scenes));
    set("grid.methods", "--methods", core::split_list(method_list(args.methods)));
    if (!args.views.empty()) set("grid.views", "--views", {args.views});
    return experiment;
}

}  // namespace

void add_run_command(CLI::App& app) {
    auto args = std::make_shared<RunArgs>();
    auto* command = app.add_subcommand(
        "run", "Compute an experiment from its file; a run that was killed goes on where it was");
    CommandRows rows(*command);
    rows.text("file",
              args->file,
              "FILE",
              "An experiment, such as experiments/quality.toml, or run.toml of a run")
        ->required();
    add_run_folder_options(*command, args->folder);
    rows.text("--size", args->size, "WIDTHxHEIGHT", "Image size instead of the file's sizes");
    add_scene_options(*command, args->scenes, "Scenes instead of the file's");
    add_method_options(*command, args->methods, "the file's");
    rows.text("--views", args->views, "N", "Views of each scene, the first N");
    add_cache_options(*command, args->cache);
    command->footer(
        "The folder is inkbench-out/NAME, or that of --out.\n"
        "Example: inkbench run experiments/smoke.toml --size 320x180\n"
        "Exit codes: 0 done, 1 the run is invalid or nothing has a score, 2 bad input or disk "
        "full, " +
        std::string(kUnscoredCode) + ", 130 interrupted.");
    command->callback(
        [args, command] { run_to_end(*command, experiment_of(*args), args->folder, args->cache); });
}

}  // namespace ink::cli
