#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "cli/options.h"
#include "core/error.h"
#include "core/parallel.h"
#include "lab/figure_set.h"
#include "lab/suite.h"

namespace ink::cli {
namespace {

constexpr int kInterrupted = 130;  // 128 + SIGINT, as shells have it

// Between them every class of line, and depth and normals that cancel.
constexpr const char* kUsualScenes = "figure,staircase,flag,tiles";

struct FiguresArgs {
    std::vector<std::string> models;
    std::string scenes;
    std::string methods;
    std::vector<std::string> settings;
    std::string pair;
    ViewOptions views;
    std::string out = "inkbench-figures";
    CacheOptions cache;
    TruthSettings truth;
    int threads = 1;
    int repetitions = 5;
    std::string seed = "0";
};

std::vector<std::string> names_of(const FiguresArgs& args) {
    std::vector<std::string> names = lab::split_list(args.scenes);
    names.insert(names.end(), args.models.begin(), args.models.end());
    return names.empty() ? lab::split_list(kUsualScenes) : names;
}

std::optional<std::pair<std::string, std::string>> pair_of(const std::string& text) {
    if (text.empty()) return std::nullopt;
    const std::vector<std::string> names = lab::split_list(text);
    if (names.size() != 2) {
        throw core::Error(
            "--pair", fmt::format("'{}' is not two methods", text), "two names, as mote4,decaudin");
    }
    return std::pair(names[0], names[1]);
}

/// One view of each scene, unless a number of views, a camera or the file's cameras were asked for.
std::vector<lab::Subject> subjects_of(const FiguresArgs& args) {
    std::vector<lab::Subject> subjects =
        lab::load_subjects(names_of(args), view_request(args.views));
    for (lab::Subject& subject : subjects) {
        if (args.views.views.empty() && args.views.eyes.empty()) subject.views.resize(1);
    }
    return subjects;
}

lab::FigureOptions figure_options(const FiguresArgs& args) {
    lab::FigureOptions options;
    options.drawing.entrants = lab::make_entrants(args.methods, args.settings);
    lab::MeasureOptions& measure = options.drawing.measure;
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
    lab::FigureOptions options = figure_options(args);
    options.command = command_line;
    const lab::FigureFiles files = lab::make_figures(subjects_of(args), options);
    for (const std::string& name : files.names)
        fmt::print("{}\n", (std::filesystem::path(args.out) / name).string());
    if (files.is_interrupted) {
        fmt::print(stderr, "inkbench: interrupted; the figures show the scenes that were drawn\n");
        throw CLI::RuntimeError(kInterrupted);
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
    command->add_option("models", args->models, "Model files, besides --scenes");
    command->add_option("--scenes",
                        args->scenes,
                        fmt::format("Built-in scenes a,b (with no model file: {})", kUsualScenes));
    command->add_option("--methods", args->methods, "Methods a,b (all unless given)");
    command->add_option("--set", args->settings, "A parameter: key=value or method.key=value")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--pair",
                        args->pair,
                        "Two methods a,b to enlarge where they differ most (unless given mote4 and "
                        "decaudin, or the first two)");
    add_view_options(*command, args->views);
    command
        ->add_option("--out", args->out, "Folder for the figures and figures.md, which lists them")
        ->capture_default_str();
    add_truth_settings(*command, args->truth);
    command->add_option("--threads", args->threads, "Threads a method may use while it is timed")
        ->capture_default_str();
    command->add_option("--repetitions", args->repetitions, "Timed drawings of a view, at most")
        ->capture_default_str();
    command->add_option("--seed", args->seed, "Of intervals and chance pictures")
        ->capture_default_str();
    add_cache_options(*command, args->cache);
    command->footer(
        "One view of each scene is drawn, its first; --views N draws N round it.\n"
        "Example: inkbench figures --scenes torus,staircase --methods mote4,decaudin --out "
        "figures\n"
        "Exit codes: 0 done, 2 bad input, 130 interrupted.");
    command->callback([args, command] {
        std::string line = "inkbench figures";
        for (const CLI::Option* option : command->get_options()) {
            if (option->count() == 0) continue;
            for (const std::string& value : option->results()) {
                const bool is_flag = option->get_expected_max() == 0;
                if (!option->get_positional()) line += " " + option->get_name();
                if (!is_flag) line += " " + value;
            }
        }
        run_figures(*args, line);
    });
}

}  // namespace ink::cli
