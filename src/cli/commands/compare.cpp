#include <memory>

#include "cli/commands/commands.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/options/run_options.h"
#include "core/error.h"
#include "experiment/options/option_table.h"
#include "harness/cells/cell.h"

namespace ink::cli {
namespace {

/// What `--quick` asks for: a first look in seconds.
constexpr experiment::ImageSize kQuickSize{640, 360};
constexpr int kQuickRepetitions = 9;

/// What `--demo` compares unless told otherwise: each kind of line and difficulty once, and of each
/// family the methods that the README recommends beside those of the sources.
constexpr const char* kDemoScenes =
    "octopus,cube,blocks,tiles,hills,gear,figure,teapot,letters,hand,chess,staircase";
constexpr const char* kDemoMethods =
    "decaudin,roberts_tuned,sobel,mote4,mote4_tuned,two_sums,auto,polygon_offset,edge_hash,"
    "inverted_hull,ids,jump_flood,surface8,surface8_depth,surface_lookup";
constexpr const char* kDemoOut = "inkbench-out/demo";

struct CompareArgs : MeasureArgs {
    CompareArgs() : MeasureArgs("compare", "") {
        options.usual().budget_ms = harness::MeasureOptions{}.budget_s * 1e3;
        options.usual().compare.own_sweep_views = 1;
    }

    bool no_sweep = false;
    bool quick = false;
    bool demo = false;
};

void apply_quick(CompareArgs& args) {
    args.options.usual().sizes = {kQuickSize};
    args.options.usual().repetitions = kQuickRepetitions;
    args.no_sweep = true;
    args.options.usual().crosscheck = args.demo;
}

void apply_demo(CompareArgs& args, const CLI::App& command) {
    args.quick = true;
    if (args.scenes.is_empty()) args.scenes.listed = {kDemoScenes};
    if (args.methods.empty()) args.methods = {kDemoMethods};
    if (command.count("--out") == 0) args.folder.out = kDemoOut;
}

experiment::Experiment experiment_of(const CompareArgs& args) {
    experiment::Experiment experiment = args.read();
    if (experiment.scenes.empty()) experiment.scenes = experiment::scenes_called("catalogue");
    if (args.quick && !args.options.has_views()) experiment.compare.views = 1;
    if (args.no_sweep) experiment.compare.own_sweep_views = 0;
    return experiment;
}

}  // namespace

void add_compare_command(CLI::App& app) {
    auto args = std::make_shared<CompareArgs>();
    auto* command = app.add_subcommand(
        "compare",
        "Draw, trace, score and time methods on scenes; write a run folder with a report");
    add_scene_options(
        *command, args->scenes, "Built-in scenes or model files (default: the catalogue)");
    add_method_options(*command, args->methods);
    add_set_option(*command, args->settings);
    ExperimentOptions& options = args->options;
    options.add_to(*command,
                   {"grid.model_list", "grid.presets", "grid.entrants", "measure.entrant_seconds"});
    options.add_to(*command, experiment::view_rows());
    add_run_folder_options(*command, args->folder);
    CommandRows rows(*command);
    // clang-format off
    rows.flag("--quick", args->quick,
              "A first look: 640x360, one view a scene, few repetitions, no sweep, no check of "
              "the truth");
    rows.flag("--demo", args->demo,
              "A dozen scenes and the main methods unless others are named, as small as with "
              "--quick, in inkbench-out/demo: half a minute");
    // clang-format on
    options.add_to(*command, truth_rows());
    options.add_to(*command, {"measure.creases"});
    options.add_to(*command, {"grid.threads", "measure.repetitions", "sweep.own_views"});
    rows.flag(
        "--no-sweep", args->no_sweep, "Draw methods at their own settings only: no sweep.csv");
    options.add_to(*command, {"answer.f_margin", "answer.budget_ms"});
    options.add_to(*command, {"grid.antialias", "measure.coverage", "measure.line_width_px"});
    options.add_to(
        *command,
        {"seed", "measure.crosscheck", "measure.images", "measure.skips_off", "study.motion"});
    add_cache_options(*command, args->cache);
    command->footer(
        "NAME is that of up to three scenes, else compare. Killed or interrupted, the same command "
        "goes on where it stopped.\n"
        "Example: inkbench compare bunny.obj spot.obj --methods mote4,decaudin --size 1920x1080\n"
        "Exit codes: 0 done, 1 the run is invalid or nothing has a score, 2 bad input, " +
        std::string(kUnscoredCode) + ", 130 interrupted.");
    command->callback([args, command] {
        if (args->demo) apply_demo(*args, *command);
        if (args->quick) apply_quick(*args);
        const experiment::Experiment experiment = experiment_of(*args);
        RunFolderOptions folder = args->folder;
        if (folder.out.empty())
            folder.out = "inkbench-out/" + name_after(experiment.scenes, experiment.name);
        run_to_end(*command, experiment, folder, args->cache);
    });
}

}  // namespace ink::cli
