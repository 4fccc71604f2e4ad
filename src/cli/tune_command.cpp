#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/options.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/param.h"
#include "tune/tune.h"
#include "tune/tune_bound.h"
#include "tune/tune_report.h"

namespace ink::cli {
namespace {

struct TuneArgs {
    std::string method;
    std::string knobs;
    std::vector<std::string> settings;
    std::string objective = "error";
    std::optional<double> budget_ms;
    int evaluations = 300;
    std::string seed = "0";
    std::string global = "crs";
    std::string local = "sbplx";
    bool no_random = false;
    bool no_bound = false;
    std::string scenes;
    ViewOptions views;
    int more_views = 0;
    std::string name;
    std::string out = "inkbench-out";
    CacheOptions cache;
    TruthSettings truth;
    int threads = core::hardware_threads();
};

/// Options that change no result, and so are no part of the command that a preset records.
constexpr const char* kUnrecorded[] = {
    "--no-random", "--no-bound", "--out", "--threads", "--cache", "--no-cache", "--help"};

std::string recorded_command(const CLI::App& command) {
    std::string line = "inkbench tune";
    for (const CLI::Option* option : command.get_options()) {
        const bool is_unrecorded =
            std::any_of(std::begin(kUnrecorded), std::end(kUnrecorded), [&](const char* name) {
                return option->check_name(name);
            });
        if (option->count() == 0 || is_unrecorded) continue;
        for (const std::string& value : option->results()) {
            const bool is_flag = option->get_expected_max() == 0;
            if (!option->get_positional()) line += " " + option->get_name();
            if (!is_flag) line += " " + value;
        }
    }
    return line;
}

void check_choice(const char* option,
                  const std::string& given,
                  const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), given) != names.end()) return;
    throw core::Error(
        option, fmt::format("there is no '{}'", given), core::known_names(names, given));
}

tune::TuneOptions tune_options(const TuneArgs& args) {
    tune::TuneOptions options;
    if (harness::split_list(args.method).size() != 1) {
        throw core::Error("METHOD",
                          fmt::format("'{}' is not one method", args.method),
                          "one name of inkbench list methods");
    }
    options.entrant = harness::make_entrants(args.method, args.settings).front();
    options.knobs = args.knobs;
    check_choice("--objective", args.objective, {"error", "scenes", "ap"});
    if (args.objective == "scenes") options.objective = tune::TuneObjective::scenes;
    if (args.objective == "ap") options.objective = tune::TuneObjective::ap;
    if (args.budget_ms && !(*args.budget_ms > 0)) {
        throw core::Error(
            "--budget-ms", fmt::format("it cannot be {}", *args.budget_ms), "above 0");
    }
    options.budget_ms = args.budget_ms;
    if (args.evaluations < 1 || args.evaluations > 1000000) {
        throw core::Error(
            "--evaluations", fmt::format("{} is not possible", args.evaluations), "1..1000000");
    }
    check_choice("--global", args.global, tune::global_searches());
    check_choice("--local", args.local, tune::local_searches());
    options.plan = {.evaluations = args.evaluations,
                    .seed = parse_seed(args.seed),
                    .global = args.global,
                    .local = args.local};
    options.random = !args.no_random;
    apply(args.truth, options.trace.truth);
    options.trace.truth.threads = core::hardware_threads();
    options.trace.cache = cache_folder(args.cache);
    options.threads = checked_threads(args.threads);
    options.out = args.out;
    options.name = args.name.empty() ? args.method + "_tuned" : args.name;
    if (options.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") !=
        std::string::npos) {
        throw core::Error("--name",
                          fmt::format("'{}' cannot be the name of a method", options.name),
                          "small letters, digits and underscores");
    }
    return options;
}

void run_tune(const TuneArgs& args, const std::string& command) {
    tune::TuneOptions options = tune_options(args);
    options.command = command;
    if (args.more_views < 0 || args.more_views > 1000) {
        throw core::Error(
            "--more-views", fmt::format("{} is not possible", args.more_views), "0..1000");
    }
    const harness::ViewRequest request = view_request(args.views);
    std::vector<harness::Subject> subjects =
        harness::load_subjects(harness::split_list(args.scenes), request);
    for (harness::Subject& subject : subjects)
        tune::add_training_views(subject, request, args.more_views);
    const tune::TuneResult result = tune::tune(subjects, options);
    if (result.is_interrupted) {
        fmt::print(stderr,
                   "inkbench: interrupted; the finished evaluations are in {}, and the same "
                   "command goes on from there\n",
                   (options.out / "evaluations.csv.part").string());
        throw CLI::RuntimeError(kInterrupted);
    }
    fmt::print("{}", tune::tune_summary(result, options));
    std::fflush(stdout);
    if (!args.no_bound) {
        fmt::print("{}", tune::tune_bound_lines(subjects, result, options));
    }
}

}  // namespace

void add_tune_command(CLI::App& app) {
    auto args = std::make_shared<TuneArgs>();
    auto* command = app.add_subcommand(
        "tune", "Find the settings of a method that make the fewest errors on the training scenes");
    command->add_option("method", args->method, "Method (see inkbench list methods)")->required();
    command->add_option("--params",
                        args->knobs,
                        "What to tune: knobs a,b or a=low..high,b (unless given: what is worth it "
                        "in the method, else its threshold)");
    add_set_option(*command, args->settings, "A parameter that stays as it is: key=value");
    command
        ->add_option(
            "--objective",
            args->objective,
            "error: 1 - F at 2 px, all training views pooled; scenes: (mean root of each "
            "scene's error) squared, so that no scene speaks for the others; ap: 1 - average "
            "precision")
        ->capture_default_str();
    command->add_option("--budget-ms",
                        args->budget_ms,
                        "Leave out settings whose median drawing takes longer on one thread; "
                        "measured, so what comes out hangs on the machine");
    command->add_option("--evaluations", args->evaluations, "Settings to try")
        ->capture_default_str();
    command->add_option("--seed", args->seed, "Of the search, a whole number")
        ->capture_default_str();
    command
        ->add_option("--global",
                     args->global,
                     fmt::format("Search for 60 % of the evaluations: {}",
                                 fmt::join(tune::global_searches(), ", ")))
        ->capture_default_str();
    command
        ->add_option(
            "--local",
            args->local,
            fmt::format("Search for the rest: {}", fmt::join(tune::local_searches(), ", ")))
        ->capture_default_str();
    command->add_flag(
        "--no-random", args->no_random, "No random search of as many evaluations beside it");
    command->add_flag(
        "--no-bound", args->no_bound, "No linear bound beside it, for methods that declare a code");
    command->add_option("--scenes",
                        args->scenes,
                        "Scenes a,b or model files that take part (all built-in ones unless "
                        "given): the training scenes are searched, the others only scored");
    add_view_options(*command, args->views);
    command
        ->add_option("--more-views",
                     args->more_views,
                     "So many views round each training scene beside its own")
        ->capture_default_str();
    add_truth_settings(*command, args->truth);
    command->add_option("--name", args->name, "Of the preset (METHOD_tuned)");
    command->add_option("--out", args->out, "Folder for evaluations.csv and NAME.toml")
        ->capture_default_str();
    command->add_option("--threads", args->threads, "Threads; nothing but times depends on it")
        ->capture_default_str();
    add_cache_options(*command, args->cache);
    command->footer(
        "Example: inkbench tune mote4 --evaluations 400 --seed 7 --out tuned\n"
        "The preset: inkbench compare --preset tuned/mote4_tuned.toml\n"
        "Exit codes: 0 done, 2 bad input, 130 interrupted (the same command goes on).");
    command->callback([args, command] { run_tune(*args, recorded_command(*command)); });
}

}  // namespace ink::cli
