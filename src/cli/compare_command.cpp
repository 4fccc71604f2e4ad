#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "cli/options.h"
#include "core/error.h"
#include "core/parallel.h"
#include "experiment/compare.h"
#include "report/statistics.h"
#include "report/verdict.h"

namespace ink::cli {
namespace {

struct CompareArgs {
    std::vector<std::string> models;
    std::string scenes;
    std::string methods;
    std::vector<std::string> settings;
    std::vector<std::string> presets;
    ViewOptions views;
    std::string out = "inkbench-out";
    CacheOptions cache;
    TruthSettings truth;
    int threads = 1;
    int repetitions = 15;
    bool no_sweep = false;
    int sweep_views = 1;
    std::string seed = "0";
    bool no_witness = false;
    bool scaling = false;
    std::string no_skip;
    bool skip_study = false;
    bool motion = false;
};

experiment::CompareOptions compare_options(const CompareArgs& args) {
    experiment::CompareOptions options;
    options.entrants = harness::make_entrants(args.methods, args.settings, args.presets);
    options.measure.threads = checked_threads(args.threads);
    if (args.repetitions < 1 || args.repetitions > 10000) {
        throw core::Error(
            "--repetitions", fmt::format("{} is not possible", args.repetitions), "1..10000");
    }
    options.measure.max_repetitions = args.repetitions;
    options.measure.min_repetitions = std::min(options.measure.min_repetitions, args.repetitions);
    options.measure.skips = harness::without_skips(options.measure.skips, args.no_skip);
    if (args.skip_study && !args.no_skip.empty()) {
        throw core::Error(
            "--skip-study", "it switches every skip itself", "no --no-skip beside it");
    }
    options.skip_study = args.skip_study;
    options.sweep.measure.threads = options.measure.threads;
    options.sweep.measure.skips = options.measure.skips;
    if (args.sweep_views < 1 || args.sweep_views > 10000) {
        throw core::Error(
            "--sweep-views", fmt::format("{} is not possible", args.sweep_views), "1..10000");
    }
    options.sweep.views = args.no_sweep ? 0 : args.sweep_views;
    apply(args.truth, options.trace.truth);
    options.trace.truth.threads = core::hardware_threads();
    options.trace.witness = !args.no_witness;
    options.study_scaling = args.scaling;
    options.study_motion = args.motion;
    options.out = args.out;
    options.trace.cache = cache_folder(args.cache);
    options.seed = parse_seed(args.seed);
    return options;
}

void run_compare(const CompareArgs& args, const std::string& command_line) {
    experiment::CompareOptions options = compare_options(args);
    options.command = command_line;
    const experiment::CompareResult result = experiment::compare(
        harness::load_subjects(scene_names(args.scenes, args.models), view_request(args.views)),
        options);
    fmt::print("{}\n", report::verdict_table(result.rows, result.curves));
    fmt::print("{}", report::threshold_lines(result.rows, result.curves));
    fmt::print("report: {}\n", result.report.string());
    for (const std::string& reason : result.void_reasons) {
        fmt::print(stderr, "inkbench: this run is void: {}\n", reason);
    }
    if (result.is_interrupted) {
        fmt::print(stderr, "inkbench: interrupted; the finished rows are in {}\n", args.out);
        throw CLI::RuntimeError(kInterrupted);
    }
    if (!result.void_reasons.empty()) throw CLI::RuntimeError(1);
}

}  // namespace

void add_compare_command(CLI::App& app) {
    auto args = std::make_shared<CompareArgs>();
    auto* command = app.add_subcommand(
        "compare", "Draw, trace, score and time methods on scenes; write rows, figures, a report");
    command->add_option("models", args->models, "Model files; none and no --scenes: the catalogue");
    command->add_option("--scenes", args->scenes, "Built-in scenes a,b (see inkbench list scenes)");
    command->add_option("--methods", args->methods, "Methods a,b (all unless given)");
    add_set_option(*command, args->settings);
    add_preset_option(*command, args->presets, "beside the methods");
    add_view_options(*command, args->views);
    command
        ->add_option("--out",
                     args->out,
                     "Folder for rows.csv, curves.csv, ladder.csv, sweep.csv, scaling.csv, "
                     "skips.csv, motion.csv, summary.csv, "
                     "report.html, verdict.md, figures")
        ->capture_default_str();
    add_truth_settings(*command, args->truth);
    command->add_option("--threads", args->threads, "Threads a method may use while it is timed")
        ->capture_default_str();
    command->add_option("--repetitions", args->repetitions, "Timed drawings of a view, at most")
        ->capture_default_str();
    command
        ->add_option(
            "--sweep-views", args->sweep_views, "Views of each scene on which sweeps are drawn")
        ->capture_default_str();
    command->add_flag(
        "--no-sweep", args->no_sweep, "Draw methods at their own settings only: no sweep.csv");
    command
        ->add_option(
            "--seed", args->seed, "Of chance pictures and of intervals; recorded in the rows")
        ->capture_default_str();
    command->add_flag(
        "--no-witness", args->no_witness, "Do not hold the truth against its witness");
    command->add_flag("--scaling",
                      args->scaling,
                      "Also time spheres of 100 to a million triangles, on 0.3 to 33 Mpx: "
                      "scaling.csv and plots, about a minute");
    command->add_flag("--motion",
                      args->motion,
                      "Also draw sequences in which the camera moves slowly, and a cube before a "
                      "camera that rolls: flicker, pops, lives of false lines; motion.csv, "
                      "roll.csv, vanishing.csv and plots, about a minute");
    command->add_option("--no-skip",
                        args->no_skip,
                        "Skips a,b to do without, or all (see inkbench list skips): other times, "
                        "the same pictures");
    command->add_flag("--skip-study",
                      args->skip_study,
                      "Measure too what each skip is worth, on scenes made for it: skips.csv and "
                      "the report's part on skips");
    add_cache_options(*command, args->cache);
    command->footer(
        "Example: inkbench compare bunny.obj spot.obj --methods mote4,decaudin --size 1920x1080\n"
        "Exit codes: 0 done, 1 the run is void, 2 bad input, 130 interrupted.");
    command->callback([args, &app] {
        std::string line = "inkbench compare";
        for (const CLI::Option* option : app.get_subcommand("compare")->get_options()) {
            if (option->count() == 0) continue;
            for (const std::string& value : option->results()) {
                const bool is_flag = option->get_expected_max() == 0;
                if (!option->get_positional()) line += " " + option->get_name();
                if (!is_flag) line += " " + value;
            }
        }
        run_compare(*args, line);
    });
}

}  // namespace ink::cli
