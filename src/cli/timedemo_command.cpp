#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/options.h"
#include "core/error.h"
#include "harness/interrupt.h"
#include "harness/out_folder.h"
#include "harness/skip_switches.h"
#include "studies/timedemo.h"

namespace ink::cli {
namespace {

struct TimedemoArgs {
    std::string scene;
    std::string view;
    std::string methods;
    std::vector<std::string> settings;
    ViewOptions views;
    int frames = 60;
    int threads = 1;
    std::string seed = "0";
    std::string no_skip;
    std::string out;
};

void run_timedemo(const TimedemoArgs& args) {
    studies::TimedemoOptions options;
    options.entrants = harness::make_entrants(args.methods, args.settings);
    options.threads = checked_threads(args.threads);
    options.skips = harness::without_skips({}, args.no_skip);
    options.seed = parse_seed(args.seed);
    options.frames = args.frames;
    if (args.frames < 2 || args.frames > 10000) {
        throw core::Error("--frames", fmt::format("{} is not possible", args.frames), "2..10000");
    }
    const harness::ViewRequest request = view_request(args.views);
    if (request.time_s || request.frame) {
        throw core::Error(
            "--time", "a time demo shows all of an animation", "no --time or --frame");
    }
    const harness::Subject subject = harness::load_one_view(args.scene, args.view, request);
    if (!args.out.empty()) harness::make_out_folder(args.out);
    const harness::InterruptGuard guard;
    const auto frames = studies::run_timedemo(subject, options);
    if (harness::is_interrupted()) {
        fmt::print(stderr, "inkbench: interrupted; nothing is written\n");
        throw CLI::RuntimeError(kInterrupted);
    }
    fmt::print("{}\n", studies::timedemo_heading(subject, options));
    fmt::print("{}", studies::timedemo_table(frames));
    if (args.out.empty()) return;
    const auto path = std::filesystem::path(args.out) / "timedemo.csv";
    studies::write_timedemo(subject, frames, path);
    fmt::print("{}\n", path.string());
}

}  // namespace

void add_timedemo_command(CLI::App& app) {
    auto args = std::make_shared<TimedemoArgs>();
    auto* command = app.add_subcommand(
        "timedemo", "Time an animation: frames per second plain, shaded and with lines");
    command->add_option("scene", args->scene, "A built-in scene or a model file")->required();
    command->add_option("--methods,--method", args->methods, "Methods a,b (all unless given)");
    add_set_option(*command, args->settings);
    command->add_option("--frames", args->frames, "Frames of each camera path")
        ->capture_default_str();
    command->add_option("--view", args->view, "Where the camera starts (the first unless given)");
    add_view_options(*command, args->views);
    command->add_option("--threads", args->threads, "Threads")->capture_default_str();
    command->add_option("--seed", args->seed, "Of the shaking camera")->capture_default_str();
    command->add_option("--no-skip", args->no_skip, "Skips a,b to do without, or all");
    command->add_option("--out", args->out, "Folder for timedemo.csv");
    command->footer(
        "Times of the first round and of those after it stand side by side: what a method keeps "
        "of a frame it has seen counts in 'no edges' and 'full'.\n"
        "With --views file, a camera that the model moves is followed first (path 'own').\n"
        "Example: inkbench timedemo gear --methods mote4,edge_hash --frames 30\n"
        "Exit codes: 0 done, 2 bad input, 130 interrupted.");
    command->callback([args] { run_timedemo(*args); });
}

}  // namespace ink::cli
