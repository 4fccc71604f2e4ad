#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/options/method_options.h"
#include "cli/options/options.h"
#include "cli/options/run_options.h"
#include "cli/options/scene_options.h"
#include "core/error.h"
#include "experiment/entrants/entrant.h"
#include "harness/cell.h"

namespace ink::cli {
namespace {

constexpr int kMostRepetitions = 10000;

/// What `--quick` asks for: a first look in seconds.
constexpr const char* kQuickSize = "640x360";
constexpr int kQuickRepetitions = 3;

/// What `--demo` compares unless told otherwise: each kind of line and difficulty once, and of each
/// family the methods that the README recommends beside those of the sources.
constexpr const char* kDemoScenes =
    "octopus,cube,blocks,tiles,hills,gear,figure,teapot,letters,hand,chess,staircase";
constexpr const char* kDemoMethods =
    "decaudin,roberts_tuned,sobel,mote4,mote4_tuned,two_sums,auto,polygon_offset,edge_hash,"
    "inverted_hull,ids,jump_flood,surface8,id_lookup";
constexpr const char* kDemoOut = "inkbench-out/demo";

struct CompareArgs {
    SceneOptions scenes;
    std::vector<std::string> methods;
    std::vector<std::string> settings;
    std::vector<std::string> presets;
    std::vector<std::string> entrants;
    double entrant_s = 60;
    ViewOptions views;
    RunFolderOptions folder{.out = "inkbench-out"};
    CacheOptions cache;
    TruthSettings truth;
    int threads = 1;
    int repetitions = 15;
    bool no_sweep = false;
    int sweep_views = 1;
    std::string seed = "0";
    bool no_crosscheck = false;
    bool scaling = false;
    std::vector<std::string> no_skip;
    bool skip_study = false;
    bool motion = false;
    bool quick = false;
    bool demo = false;
    std::string images = "first";
};

int checked(int value, const char* option) {
    if (value < 1 || value > kMostRepetitions) {
        throw core::Error(option,
                          fmt::format("{} is not possible", value),
                          fmt::format("1..{}", kMostRepetitions));
    }
    return value;
}

void apply_quick(CompareArgs& args, const CLI::App& command) {
    if (command.count("--size") == 0) args.views.size = kQuickSize;
    if (command.count("--repetitions") == 0) args.repetitions = kQuickRepetitions;
    args.no_sweep = true;
    args.no_crosscheck = args.no_crosscheck || !args.demo;
}

void apply_demo(CompareArgs& args, const CLI::App& command) {
    args.quick = true;
    if (args.scenes.is_empty()) args.scenes.listed = {kDemoScenes};
    if (args.methods.empty()) args.methods = {kDemoMethods};
    if (command.count("--out") == 0) args.folder.out = kDemoOut;
}

experiment::Experiment experiment_of(const CompareArgs& args) {
    experiment::Experiment experiment;
    experiment.where = "inkbench compare";
    experiment.name = "compare";
    experiment.kind = experiment::ExperimentKind::compare;
    experiment.seed = parse_seed(args.seed);
    const std::string methods = method_list(args.methods);
    for (const harness::MethodConfig& config :
         harness::make_configs(methods, args.settings, args.presets))
        if (!methods.empty() && !config.owned) experiment.methods.push_back(config.info->name);
    experiment.settings = args.settings;
    experiment.presets = args.presets;
    experiment.entrants = args.entrants;
    experiment.entrant_s = args.entrant_s;
    for (const std::string& entrant : args.entrants)
        (void)experiment::parse_entrant(entrant);  // refused before anything is loaded
    experiment.view_request = view_request(args.views);
    experiment.sizes = {{experiment.view_request.width_px, experiment.view_request.height_px}};
    experiment.threads = {checked_threads(args.threads)};
    experiment.scenes = scene_names(args.scenes);
    if (experiment.scenes.empty()) experiment.scenes = experiment::scenes_called("catalogue");
    if (args.quick && args.views.views.empty() && args.views.eyes.empty()) experiment.views = 1;
    experiment.repetitions = checked(args.repetitions, "--repetitions");
    experiment.budget_s = harness::MeasureOptions{}.budget_s;
    experiment.own_sweep_views = args.no_sweep ? 0 : checked(args.sweep_views, "--sweep-views");
    experiment.skips_off = harness::split_list(skip_list(args.no_skip));
    if (args.skip_study && !args.no_skip.empty()) {
        throw core::Error(
            "--skip-study", "it switches every skip itself", "no --no-skip beside it");
    }
    apply(args.truth, experiment);
    experiment.crosscheck = !args.no_crosscheck;
    experiment.images = kept_images(args.images);
    experiment.study_scaling = args.scaling;
    experiment.study_motion = args.motion;
    experiment.study_skips = args.skip_study;
    return experiment;
}

void add_study_options(CLI::App& command, CompareArgs& args) {
    command.add_flag("--scaling",
                     args.scaling,
                     "Also time spheres of 100 to a million triangles, on 0.3 to 33 Mpx: "
                     "scaling.csv and plots, about a minute");
    command.add_flag("--motion",
                     args.motion,
                     "Also draw sequences in which the camera moves slowly, and a cube before a "
                     "camera that rolls: flicker, pops, lives of false lines; motion.csv, "
                     "roll.csv, vanishing.csv and plots, about a minute");
    command.add_flag("--skip-study",
                     args.skip_study,
                     "Also measure how much time each skip saves, on scenes made for it: skips.csv "
                     "and a part of the report");
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
    add_preset_option(*command, args->presets, "beside the methods");
    add_entrant_options(*command, args->entrants, args->entrant_s);
    add_view_options(*command, args->views);
    add_run_folder_options(*command, args->folder);
    command->add_flag("--quick",
                      args->quick,
                      "A first look: 640x360, one view a scene, few repetitions, no sweep, no "
                      "check of the truth");
    command->add_flag(
        "--demo",
        args->demo,
        "A dozen scenes and the main methods unless others are named, as small as with "
        "--quick, in inkbench-out/demo: half a minute");
    add_truth_settings(*command, args->truth);
    add_threads_option(*command, args->threads, "Threads a method may use while it is timed");
    command->add_option("--repetitions", args->repetitions, "Timed drawings of a view, at most")
        ->capture_default_str();
    command
        ->add_option(
            "--sweep-views", args->sweep_views, "Views of each scene on which sweeps are drawn")
        ->capture_default_str();
    command->add_flag(
        "--no-sweep", args->no_sweep, "Draw methods at their own settings only: no sweep.csv");
    add_seed_option(
        *command, args->seed, "Of random images and of intervals; recorded in the rows");
    command->add_flag("--no-crosscheck,--no-witness",
                      args->no_crosscheck,
                      "Skip the independent check of the ground truth");
    command
        ->add_option("--images",
                     args->images,
                     "Views whose images are kept: none, the first of each scene, or all")
        ->capture_default_str();
    add_no_skip_option(*command, args->no_skip);
    add_study_options(*command, *args);
    add_cache_options(*command, args->cache);
    command->footer(
        "Killed or interrupted, the same command goes on where it stopped.\n"
        "Example: inkbench compare bunny.obj spot.obj --methods mote4,decaudin --size 1920x1080\n"
        "Exit codes: 0 done, 1 the run is invalid or nothing has a score, 2 bad input, " +
        std::string(kUnscoredCode) + ", 130 interrupted.");
    command->callback([args, command] {
        if (args->demo) apply_demo(*args, *command);
        if (args->quick) apply_quick(*args, *command);
        experiment::Experiment experiment = experiment_of(*args);
        experiment.command = run_command_text(*command);
        run_to_end(experiment, args->folder, args->cache);
    });
}

}  // namespace ink::cli
