#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "cli/commands.h"
#include "cli/method_options.h"
#include "cli/name_list.h"
#include "cli/options.h"
#include "cli/scene_options.h"
#include "core/error.h"
#include "core/parallel.h"
#include "experiment/summary/summary.h"
#include "harness/suite.h"
#include "report/figure_run.h"
#include "report/figure_set.h"

namespace ink::cli {
namespace {

// Between them every class of line, and depth and normals that cancel.
constexpr const char* kUsualScenes = "figure,staircase,flag,tiles";

struct FiguresArgs {
    SceneOptions scenes;
    std::vector<std::string> methods;
    std::vector<std::string> settings;
    std::string pair;
    std::string from;
    bool has_size = false;
    ViewOptions views;
    std::string out = "inkbench-figures";
    CacheOptions cache;
    TruthSettings truth;
    int threads = 1;
    int repetitions = 5;
    std::string seed = "0";
};

constexpr std::size_t kScenesOfRun = 4;

/// What is drawn; `run` are the rows that --from names, if it does.
std::vector<std::string> names_of(const FiguresArgs& args, const std::vector<harness::Row>& run) {
    std::vector<std::string> names = scene_names(args.scenes);
    if (!names.empty()) return names;
    if (run.empty()) return harness::split_list(kUsualScenes);
    names = report::drawable_scenes(run, kScenesOfRun);
    if (!names.empty()) return names;
    throw core::Error("--from " + args.from,
                      "none of the run's scenes is built in, so that none can be drawn anew",
                      "their model files as well, or --scenes");
}

std::optional<std::pair<std::string, std::string>> pair_of(const std::string& text) {
    if (text.empty()) return std::nullopt;
    const std::vector<std::string> names = harness::split_list(text);
    if (names.size() != 2) {
        throw core::Error(
            "--pair", fmt::format("'{}' is not two methods", text), "two names, as mote4,decaudin");
    }
    return std::pair(names[0], names[1]);
}

/// One view of each scene, unless a number of views, a camera or the file's cameras were asked for.
std::vector<harness::SceneViews> scenes_of(const FiguresArgs& args,
                                           const std::vector<harness::Row>& run) {
    harness::ViewRequest request = view_request(args.views);
    if (!run.empty() && !args.has_size) {
        request.width_px = run.front().width;
        request.height_px = run.front().height;
    }
    std::vector<harness::SceneViews> scenes = harness::load_scenes(names_of(args, run), request);
    for (harness::SceneViews& scene_views : scenes) {
        if (args.views.views.empty() && args.views.eyes.empty()) scene_views.views.resize(1);
    }
    return scenes;
}

/// The methods of the run with its settings, those alone that --methods names, if it does.
std::vector<harness::MethodConfig> configs_of_run(const FiguresArgs& args,
                                                  const std::vector<harness::Row>& run) {
    if (!args.settings.empty()) {
        throw core::Error("--set", "methods have the settings of the run", "no --from beside it");
    }
    const std::vector<harness::MethodConfig> all = report::configs_of(run);
    if (args.methods.empty()) return all;
    std::vector<std::string> names;
    for (const harness::MethodConfig& config : all)
        names.push_back(config.info->name);
    std::vector<harness::MethodConfig> chosen;
    for (const std::string& name :
         listed_names(args.methods, {"--methods", "method in the run", names})) {
        const auto at = std::find(names.begin(), names.end(), name);
        chosen.push_back(all[static_cast<std::size_t>(at - names.begin())]);
    }
    return chosen;
}

/// The run's rows of those methods and of the baselines.
report::ChartSource chart_source(const FiguresArgs& args,
                                 const std::vector<harness::Row>& run,
                                 const std::vector<harness::MethodConfig>& configs) {
    report::ChartSource source;
    std::set<std::string> scenes;
    std::set<std::string> names;
    for (const harness::MethodConfig& config : configs)
        names.insert(config.info->name);
    for (const harness::Row& row : run) {
        if (!harness::is_baseline(row.method) && names.count(row.method) == 0) continue;
        scenes.insert(row.scene);
        source.rows.push_back(row);
    }
    source.words = fmt::format("Of the run in {}: {} scene{} of {} x {} px.",
                               args.from,
                               scenes.size(),
                               scenes.size() == 1 ? "" : "s",
                               run.front().width,
                               run.front().height);
    return source;
}

report::FigureOptions figure_options(const FiguresArgs& args,
                                     const std::vector<harness::Row>& run) {
    report::FigureOptions options;
    if (run.empty()) {
        options.drawing.configs = harness::make_configs(method_list(args.methods), args.settings);
    } else {
        options.drawing.configs = configs_of_run(args, run);
        options.charts = chart_source(args, run, options.drawing.configs);
    }
    harness::MeasureOptions& measure = options.drawing.measure;
    measure.threads = checked_threads(args.threads);
    if (args.repetitions < 1 || args.repetitions > 10000) {
        throw core::Error(
            "--repetitions", fmt::format("{} is not possible", args.repetitions), "1..10000");
    }
    measure.max_repetitions = args.repetitions;
    measure.min_repetitions = std::min(measure.min_repetitions, args.repetitions);
    apply(args.truth, options.drawing.trace.truth);
    options.drawing.trace.truth.threads = core::hardware_threads();
    options.drawing.trace.cache = cache_folder(args.cache);
    options.drawing.seed = parse_seed(args.seed);
    options.out = args.out;
    options.pair = pair_of(args.pair);
    return options;
}

void run_figures(const FiguresArgs& args, const std::string& command_line) {
    const std::vector<harness::Row> run =
        args.from.empty() ? std::vector<harness::Row>() : report::rows_to_draw(args.from);
    report::FigureOptions options = figure_options(args, run);
    options.command = command_line;
    const report::FigureFiles files = report::make_figures(scenes_of(args, run), options);
    for (const std::string& name : files.names)
        fmt::print("{}\n", (std::filesystem::path(args.out) / name).string());
    if (files.is_interrupted) {
        end_interrupted("the figures show the scenes that were drawn");
    }
}

}  // namespace

void add_figures_command(CLI::App& app) {
    auto args = std::make_shared<FiguresArgs>();
    args->views.size = "640x360";
    auto* command = app.add_subcommand(
        "figures",
        "Make the comparison figures of a paper: strips, error against time, classes, buffers, "
        "enlarged differences");
    add_scene_options(*command,
                      args->scenes,
                      fmt::format("Built-in scenes or model files (default: {})", kUsualScenes));
    add_method_options(*command, args->methods);
    add_set_option(*command, args->settings);
    command
        ->add_option("--pair",
                     args->pair,
                     "Two methods a,b to enlarge where they differ most (default: mote4 and "
                     "decaudin, or the first two)")
        ->type_name("METHODS");
    command
        ->add_option("--from",
                     args->from,
                     "The folder of a finished compare or run: charts come from its rows.csv, "
                     "pictures are drawn with its methods, settings, size and (up to four) "
                     "scenes")
        ->type_name("DIR");
    add_view_options(*command, args->views);
    add_out_folder_option(
        *command, args->out, "Folder for the figures and figures.md, which lists them");
    add_truth_settings(*command, args->truth);
    add_threads_option(*command, args->threads, "Threads a method may use while it is timed");
    command->add_option("--repetitions", args->repetitions, "Timed drawings of a view, at most")
        ->capture_default_str();
    add_seed_option(*command, args->seed, "Of intervals and random images");
    add_cache_options(*command, args->cache);
    add_quiet_option(*command);
    command->footer(
        "One view of each scene is drawn, its first; --views N draws N round it.\n"
        "Example: inkbench figures --scenes torus,staircase --methods mote4,decaudin --out figs\n"
        "         inkbench figures --from inkbench-out --out figs\n"
        "Exit codes: 0 done, 2 bad input, 130 interrupted.");
    command->callback([args, command] {
        args->has_size = command->count("--size") > 0;
        run_figures(*args, recorded_command(*command));
    });
}

}  // namespace ink::cli
