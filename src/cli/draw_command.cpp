#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/draw_options.h"
#include "cli/options.h"
#include "core/error.h"
#include "lab/drawing.h"
#include "lab/exr_layers.h"
#include "lab/picture.h"
#include "lab/skip_switches.h"

namespace ink::cli {
namespace {

struct DrawArgs {
    std::string scene;
    std::string view;
    std::string method = "mote4";
    std::vector<std::string> settings;
    ViewOptions views;
    LookOptions looks;
    std::string file;
    bool strength = false;
    int threads = 1;
    std::string no_skip;
};

void run_draw(const DrawArgs& args) {
    lab::DrawOptions options = drawing_looks(args.looks);
    if (lab::split_list(args.method).size() != 1) {
        throw core::Error("--method",
                          fmt::format("'{}' is not one method", args.method),
                          "one name of inkbench list methods");
    }
    const lab::Entrant entrant = lab::make_entrants(args.method, args.settings).front();
    options.skips = lab::without_skips({}, args.no_skip);
    options.threads = checked_threads(args.threads);
    check_output_path(args.file, {".png", ".exr"});
    const lab::Subject subject =
        lab::load_one_view(args.scene, args.view, view_request(args.views));
    const lab::Drawing drawing = lab::make_drawing(subject, entrant, options);
    const std::filesystem::path path = args.file;
    if (path.extension() == ".exr") {
        lab::write_drawing_exr(subject, entrant, drawing, path);
    } else if (args.strength) {
        lab::write_strengths(drawing.strengths, path);
    } else {
        lab::write_drawing(drawing.picture, path);
    }
    fmt::print("{}\n", args.file);
}

}  // namespace

void add_draw_command(CLI::App& app) {
    auto args = std::make_shared<DrawArgs>();
    auto* command = app.add_subcommand("draw", "Draw one picture with one method");
    command->add_option("scene", args->scene, "A built-in scene or a model file")->required();
    command->add_option("-o,--output", args->file, "PNG or EXR file to write")->required();
    command->add_option("--method,--methods", args->method, "Method")->capture_default_str();
    command->add_option("--set", args->settings, "A parameter of the method: key=value")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--view", args->view, "Name of the view (the first unless given)");
    add_view_options(*command, args->views);
    add_look_options(*command, args->looks);
    command->add_flag(
        "--strength",
        args->strength,
        "Write the strengths (grey) instead of the picture, for inkbench score; an EXR "
        "has both anyway");
    command->add_option("--threads", args->threads, "Threads")->capture_default_str();
    command->add_option("--no-skip",
                        args->no_skip,
                        "Skips a,b to do without, or all (see inkbench list skips); the picture "
                        "is the same");
    command->footer(
        "Example: inkbench draw torus --method decaudin --shading toon --antialias 4 -o torus.png");
    command->callback([args] { run_draw(*args); });
}

}  // namespace ink::cli
