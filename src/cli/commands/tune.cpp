#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <memory>
#include <utility>

#include "cli/commands/commands.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/place.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "core/parallel.h"
#include "core/param.h"
#include "experiment/experiment_plan.h"
#include "experiment/options/option_table.h"
#include "experiment/run_data.h"
#include "methods/method_configs.h"
#include "methods/presets.h"
#include "report/run_page.h"
#include "search/search.h"
#include "tune/tune.h"
#include "tune/tune_objective.h"
#include "tune/tune_report.h"

namespace ink::cli {
namespace {

experiment::Experiment usual_search() {
    experiment::Experiment usual;
    usual.threads = {core::hardware_threads()};
    return usual;
}

struct TuneArgs {
    ExperimentOptions options{usual_search()};
    std::string method;                ///< by itself, unless --method is there: a scene then
    std::vector<std::string> methods;  ///< by --method
    std::vector<std::string> settings;
    bool no_random = false;
    SceneOptions scenes;
    std::vector<std::string> unseen;
    std::string out;
    CacheOptions cache;
    tune::TuneOptions tune;  ///< the rest, as the search takes it
};

/// Options that change no result, and so are no part of the command that a preset records.
const std::vector<std::string> kUnrecorded = {
    "--no-random", "--out", "--force", "--threads", "--cache", "--no-cache", "--help"};

/// `METHOD SCENE...`, or `--method METHOD SCENE...`.
std::string method_of(const TuneArgs& args) {
    if (!args.methods.empty()) return one_method(args.methods, "");
    if (!args.method.empty()) return one_method({args.method}, "", "METHOD");
    throw core::Error("tune", "the method is missing", "one name of inkbench list methods");
}

std::vector<std::string> scenes_of(const TuneArgs& args) {
    SceneOptions scenes = args.scenes;
    const bool is_scene = !args.methods.empty() && !args.method.empty();
    if (is_scene) scenes.named.insert(scenes.named.begin(), args.method);
    return scene_names(scenes);
}

/// The preset is called after its models, in letters that a method's name may have.
std::string name_of(const TuneArgs& args) {
    if (!args.tune.name.empty()) return args.tune.name;
    std::string name = method_of(args) + "_" + name_after(scenes_of(args), "tuned");
    for (char& c : name) {
        const auto letter = static_cast<unsigned char>(c);
        c = std::isalnum(letter) != 0 ? static_cast<char>(std::tolower(letter)) : '_';
    }
    return name;
}

method::MethodConfig with_crease(const method::MethodConfig& config, double crease_deg) {
    std::vector<method::MethodConfig> configs = {config};
    methods::follow_crease(crease_deg, configs);
    return configs.front();
}

tune::TuneOptions tune_options(const TuneArgs& args) {
    const experiment::Experiment asked = args.options.read();
    tune::TuneOptions options = args.tune;
    options.config = methods::make_configs(method_of(args), args.settings).front();
    if (options.budget_ms && !(*options.budget_ms > 0)) {
        throw core::Error(
            "--budget-ms", fmt::format("it cannot be {}", *options.budget_ms), "above 0");
    }
    options.plan.seed = asked.seed;
    options.random = !args.no_random;
    options.trace = experiment::trace_of(asked, cache_folder(args.cache));
    if (!tune::TuneSpace(*options.config.info, options.parameters).has("crease_deg"))
        options.config = with_crease(options.config, asked.crease_deg);
    options.threads = asked.threads.front();
    options.name = name_of(args);
    methods::check_name(options.name, "--name");
    options.out = args.out.empty() ? "inkbench-out/" + options.name : args.out;
    return options;
}

/// Models that a list keeps from those that settings may be found on are only scored.
void spare_listed(const std::vector<harness::SceneViews>& scenes, tune::TuneOptions& options) {
    for (const harness::SceneViews& scene_views : scenes) {
        const scene::Scene& scene = scene_views.scene;
        if (scene.split == scene::Split::real && !scene.kind.empty())
            options.unseen.insert(scene.name);
    }
}

/// Scenes and models that are only scored, after those that take part in the search.
void add_unseen(const TuneArgs& args,
                const harness::ViewRequest& request,
                std::vector<harness::SceneViews>& scenes,
                tune::TuneOptions& options) {
    if (args.unseen.empty()) return;
    const std::vector<std::string> names = scene_names({.listed = {}, .named = args.unseen});
    for (harness::SceneViews& scene_views : harness::load_scenes(names, request)) {
        const std::string& name = scene_views.scene.name;
        const bool is_there = std::any_of(scenes.begin(), scenes.end(), [&](const auto& other) {
            return other.scene.name == name;
        });
        if (is_there) {
            throw core::Error("--unseen",
                              fmt::format("{} takes part in the search", name),
                              "other scenes than those that are searched");
        }
        options.unseen.insert(name);
        scenes.push_back(std::move(scene_views));
    }
}

void run_tune(const TuneArgs& args, const std::string& command) {
    tune::TuneOptions options = tune_options(args);
    options.command = command;
    const harness::ViewRequest request = views_of(args.options.read());
    std::vector<harness::SceneViews> scenes = harness::load_scenes(scenes_of(args), request);
    spare_listed(scenes, options);
    add_unseen(args, request, scenes, options);
    for (const harness::SceneViews& scene_views : scenes)
        print_notes(scene_views);
    const std::string what_is_left =
        fmt::format("the finished evaluations are in {}, and the same command goes on from there",
                    (options.out / "evaluations.csv.part").string());
    const tune::TuneResult result = [&] {
        const core::InterruptGuard guard(what_is_left);
        return tune::tune(scenes, options);
    }();
    if (result.is_interrupted) end_interrupted(what_is_left);
    fmt::print("{}", tune::tune_summary(result, options));
    const std::filesystem::path page = options.out / "report.html";
    report::write_run_page({experiment::read_run(options.out)}, page);
    fmt::print("report: {}\n", page.string());
    std::fflush(stdout);
}

}  // namespace

void add_tune_command(CLI::App& app) {
    auto args = std::make_shared<TuneArgs>();
    auto* command = app.add_subcommand(
        "tune", "Find the settings of a method that make the fewest errors on the training scenes");
    CommandRows rows(*command);
    // clang-format off
    // In capitals as there is an option of the same name; see add_scene_options.
    rows.text("METHOD", args->method, "METHOD",
              "Method to tune (see inkbench list methods), if not named by --method");
    rows.list("--method,--methods", args->methods, "METHOD", "The same, as an option");
    rows.text("--params", args->tune.parameters, "PARAMS",
              "What to tune: parameters a,b or a=low..high,b (default: those that the method "
              "marks as tunable, else its threshold)");
    add_set_option(*command, args->settings, "A fixed parameter: key=value");
    rows.choice("--objective", args->tune.objective, tune::objective_names(),
                "What the search minimises. pooled: 1 - F at 2 px, all training views pooled; "
                "scenes: (mean root of each scene's error) squared, so that every scene "
                "counts; kinds: the same over kinds of scenes (--model-list); worst: the "
                "error of the worst kind; even: the mean error of kinds before the search, less "
                "what is gained, of no scene more than 0.03");
    rows.number("--budget-ms", args->tune.budget_ms, kAnyNumber, "MS",
                "Leave out settings whose median drawing takes longer on one thread; measured, "
                "so results depend on the machine");
    rows.number("--evaluations", args->tune.plan.evaluations, {1, 1e6}, "N", "Settings to try");
    args->options.add_to(*command, {"seed"}, "Of the search");
    rows.choice("--global", args->tune.plan.global, search::global_searches(),
                "Search for the first 60 % of the evaluations; the rest are local");
    rows.flag("--no-random", args->no_random,
              "Skip the random search with as many evaluations");
    // clang-format on
    add_scene_options(*command,
                      args->scenes,
                      "Scenes or model files that take part (default: the catalogue): training "
                      "scenes and models are searched, held-out scenes only scored");
    args->options.add_to(*command,
                         {"grid.model_list"},
                         "Says of model files which kind of thing they are, and which may be "
                         "searched, the others being only scored: a TOML file like "
                         "experiments/models.toml");
    rows.list("--unseen", args->unseen, "SCENES", "Scenes or model files that are only scored");
    args->options.add_to(*command, experiment::view_rows());
    args->options.add_to(*command, truth_rows());
    rows.text("--name",
              args->tune.name,
              "NAME",
              "Name of the preset (default: METHOD and up to three scenes, else METHOD_tuned)");
    add_out_folder_option(
        *command, args->out, "Folder of the run, with NAME.toml (default: inkbench-out/NAME)");
    rows.flag("--force",
              args->tune.is_forced,
              "Throw away the run that is in the folder, whatever it is");
    args->options.add_to(*command, {"grid.threads"}, "Threads; only times depend on it");
    add_cache_options(*command, args->cache);
    add_quiet_option(*command);
    command->footer(
        "Example: inkbench tune mote4 --evaluations 400 --seed 7 --out tuned\n"
        "On your own models: inkbench tune mote4 my.glb other.obj --unseen third.obj\n"
        "The preset: inkbench compare --preset tuned/mote4_tuned.toml\n"
        "Exit codes: 0 done, 2 bad input, 130 interrupted (the same command goes on).");
    command->callback(
        [args, command] { run_tune(*args, recorded_command(*command, kUnrecorded)); });
}

}  // namespace ink::cli
