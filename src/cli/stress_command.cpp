#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/options.h"
#include "core/error.h"
#include "core/parallel.h"
#include "experiment/stress.h"

namespace ink::cli {
namespace {

struct StressArgs {
    std::string axes;
    std::string methods;
    std::vector<std::string> settings;
    int points = 0;
    ViewOptions views;
    int threads = 1;
    std::string seed = "0";
    CacheOptions cache;
    std::string out = "inkbench-out/stress";
};

std::vector<const studies::StressAxis*> chosen_axes(const std::string& list) {
    std::vector<const studies::StressAxis*> axes;
    for (const std::string& name : harness::split_list(list)) {
        const studies::StressAxis* axis = &studies::find_stress_axis(name);
        for (const studies::StressAxis* known : axes) {
            if (known == axis)
                throw core::Error("--axes", fmt::format("'{}' is named twice", name), "each once");
        }
        axes.push_back(axis);
    }
    if (axes.empty()) {
        for (const studies::StressAxis& axis : studies::stress_axes())
            axes.push_back(&axis);
    }
    return axes;
}

/// What the user typed, as far as it says what was done: not where it was written.
std::string command_line(const StressArgs& args) {
    std::string text = "inkbench stress";
    if (!args.axes.empty()) text += " --axes " + args.axes;
    if (!args.methods.empty()) text += " --methods " + args.methods;
    for (const std::string& setting : args.settings)
        text += " --set " + setting;
    if (args.points > 0) text += fmt::format(" --points {}", args.points);
    return text + fmt::format(" --size {} --seed {}", args.views.size, args.seed);
}

void run_stress_command(const StressArgs& args) {
    experiment::StressOptions options;
    options.axes = chosen_axes(args.axes);
    options.entrants = harness::make_entrants(args.methods, args.settings);
    options.measure.threads = checked_threads(args.threads);
    options.seed = parse_seed(args.seed);
    if (args.points != 0) {
        if (args.points < 2 || args.points > 1000) {
            throw core::Error(
                "--points", fmt::format("{} is not possible", args.points), "2..1000");
        }
        options.points = args.points;
    }
    const harness::ViewRequest request = view_request(args.views);
    harness::check_size(request.width_px, request.height_px);
    options.size = {request.width_px, request.height_px};
    options.trace.cache = cache_folder(args.cache);
    options.trace.truth.threads = core::hardware_threads();
    options.out = args.out;
    options.command = command_line(args);
    const experiment::StressResult result = experiment::run_stress(options);
    fmt::print("{}{}\n", experiment::stress_table(result.points), result.page.string());
    if (result.is_interrupted) {
        fmt::print(stderr, "inkbench: interrupted; what was finished is written\n");
        throw CLI::RuntimeError(kInterrupted);
    }
    if (result.counts.is_clean()) return;
    fmt::print(stderr,
               "inkbench: {} numbers not finite, {} codes overflown, {} cells lost, {} pictures "
               "that differ\n",
               result.counts.non_finite,
               result.counts.overflow,
               result.counts.lost,
               result.counts.differing);
    throw CLI::RuntimeError(1);
}

}  // namespace

void add_stress_command(CLI::App& app) {
    auto args = std::make_shared<StressArgs>();
    args->views.size = "480x270";
    auto* command =
        app.add_subcommand("stress", "Sweep one difficulty at a time: error curves per method");
    command->add_option("--axes,--axis", args->axes, "Axes a,b (all unless given; list axes)");
    command->add_option("--methods,--method", args->methods, "Methods a,b (all unless given)");
    add_set_option(*command, args->settings);
    command->add_option("--points", args->points, "Points of an axis at most (all unless given)");
    command->add_option("--size", args->views.size, "Size of a picture")->capture_default_str();
    command->add_option("--threads", args->threads, "Threads of a method")->capture_default_str();
    command->add_option("--seed", args->seed, "Of the intervals")->capture_default_str();
    add_cache_options(*command, args->cache);
    command->add_option("--out", args->out, "Folder for rows, summary, page and figures")
        ->capture_default_str();
    command->footer(
        "Writes stress.csv, stress_summary.csv, stress.html and figures/stress_<axis>.svg.\n"
        "Example: inkbench stress --axes grazing,origin --methods mote4,decaudin\n"
        "Exit codes: 0 done; 1 a number was not finite, a code overflowed, a cell was lost or "
        "pictures differ that must not; 2 bad input; 130 interrupted.");
    command->callback([args] { run_stress_command(*args); });
}

}  // namespace ink::cli
