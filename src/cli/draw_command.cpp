#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/options.h"
#include "core/error.h"
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
    std::string file;
    std::string shading = "none";
    bool strength = false;
    int threads = 1;
    std::string no_skip;
};

lab::Shading parse_shading(const std::string& text) {
    if (text == "none") return lab::Shading::none;
    if (text == "gouraud") return lab::Shading::gouraud;
    throw core::Error("--shading",
                      fmt::format("there is no shading '{}'", text),
                      core::known_names({"none", "gouraud"}, text));
}

void run_draw(const DrawArgs& args) {
    const lab::Shading shading = parse_shading(args.shading);
    if (lab::split_list(args.method).size() != 1) {
        throw core::Error("--method",
                          fmt::format("'{}' is not one method", args.method),
                          "one name of inkbench list methods");
    }
    const lab::Entrant entrant = lab::make_entrants(args.method, args.settings).front();
    const auto skips = lab::without_skips({}, args.no_skip);
    const int threads = checked_threads(args.threads);
    check_output_path(args.file, {".png", ".exr"});
    const lab::Subject subject =
        lab::load_one_view(args.scene, args.view, view_request(args.views));
    const auto strengths = lab::draw_strengths(subject, entrant, threads, skips);
    const std::filesystem::path path = args.file;
    if (path.extension() == ".exr") {
        const auto picture = lab::compose_drawing(subject, entrant, strengths, shading);
        lab::write_drawing_exr(subject, entrant, strengths, picture, path);
    } else if (args.strength) {
        lab::write_strengths(strengths, path);
    } else {
        lab::write_drawing(subject, entrant, strengths, shading, path);
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
    command->add_option("--set", args->settings, "A parameter: key=value")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--view", args->view, "Name of the view (the first unless given)");
    add_view_options(*command, args->views);
    command->add_option("--shading", args->shading, "Under the lines: none, gouraud")
        ->capture_default_str();
    command->add_flag(
        "--strength",
        args->strength,
        "Write the strengths (grey) instead of black lines, for inkbench score; an EXR "
        "has both anyway");
    command->add_option("--threads", args->threads, "Threads")->capture_default_str();
    command->add_option("--no-skip",
                        args->no_skip,
                        "Skips a,b to do without, or all (see inkbench list skips); the picture "
                        "is the same");
    command->footer(
        "Example: inkbench draw torus --method decaudin --shading gouraud -o torus.png");
    command->callback([args] { run_draw(*args); });
}

}  // namespace ink::cli
