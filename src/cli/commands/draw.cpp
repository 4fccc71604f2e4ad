#include <fmt/format.h>

#include <memory>

#include "cli/commands/commands.h"
#include "cli/options/command_rows.h"
#include "cli/options/draw_options.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/place.h"
#include "core/error.h"
#include "draw/drawing.h"
#include "draw/exr_layers.h"
#include "experiment/options/option_table.h"
#include "harness/cells/cell.h"
#include "image_io/image_file.h"
#include "methods/method_configs.h"

namespace ink::cli {
namespace {

struct DrawArgs {
    ExperimentOptions options;
    SceneOptions scene;
    std::string view;
    std::vector<std::string> methods;
    std::vector<std::string> settings;
    LookOptions looks;
    std::string file;
    bool edge_response = false;
    bool no_lines = false;
    std::string layer;
};

constexpr const char* kDrawnMethod = "mote4";  // unless one is named

method::MethodConfig config_of(const DrawArgs& args, const std::vector<std::string>& presets) {
    if (presets.empty()) {
        return methods::make_configs(one_method(args.methods, kDrawnMethod), args.settings).front();
    }
    if (presets.size() > 1 || !args.methods.empty()) {
        throw core::Error("--preset", "an image is of one method", "one file, no --method");
    }
    std::vector<method::MethodConfig> configs = {methods::preset_config(presets.front())};
    methods::apply_settings(args.settings, configs);
    return configs.front();
}

void refuse_with_layer(bool is_given, const char* needs) {
    if (is_given) throw core::Error("--layer", "a layer comes as it is", needs);
}

void refuse_no_lines(const DrawArgs& args) {
    const auto refuse_if = [](bool is_so, const char* needs) {
        if (is_so) throw core::Error("--no-lines", "it would do nothing here", needs);
    };
    refuse_if(args.looks.shading == "none", "--shading NAME with it");
    refuse_if(args.edge_response, "no --response");
    refuse_if(std::filesystem::path(args.file).extension() == ".exr",
              "a PNG file; an EXR has the shading as a layer");
}

/// One of the method's own images instead of a drawing.
void write_layer(const DrawArgs& args,
                 const harness::SceneViews& scene_views,
                 const method::MethodConfig& config,
                 const draw::DrawOptions& options) {
    const method::Layer layer = draw::draw_layer(scene_views, config, args.layer, options);
    image_io::write_png(layer.rgb, args.file);
    fmt::print("{}\n", args.file);
}

void run_draw(const DrawArgs& args) {
    const experiment::Experiment asked = args.options.read();
    draw::DrawOptions options = drawing_looks(args.looks);
    const method::MethodConfig config = config_of(args, asked.compare.presets);
    options.skips = harness::without_skips({}, asked.compare.skips_off);
    options.threads = asked.threads.front();
    check_output_path(args.file, {".png", ".exr"});
    const std::filesystem::path path = args.file;
    if (args.no_lines) refuse_no_lines(args);
    if (!args.layer.empty()) {
        refuse_with_layer(path.extension() == ".exr", "a PNG file; an EXR has all layers");
        refuse_with_layer(args.edge_response, "no --response");
        refuse_with_layer(args.no_lines, "no --no-lines");
        refuse_with_layer(args.looks != LookOptions{}, "no option of the drawing's looks");
    }
    const harness::SceneViews scene_views =
        harness::load_one_view(one_scene(args.scene, "draw"), args.view, views_of(asked));
    print_notes(scene_views);
    if (!args.layer.empty()) return write_layer(args, scene_views, config, options);
    const draw::Drawing drawing = draw::make_drawing(scene_views, config, options);
    if (path.extension() == ".exr") {
        const auto layers = draw::draw_layers(scene_views, config, options);
        draw::write_drawing_exr(scene_views, config, drawing, layers, path);
    } else if (args.edge_response) {
        image_io::write_png(drawing.edge_responses, path);
    } else if (args.no_lines) {
        image_io::write_png(drawing.shading, path);
    } else {
        draw::write_drawing(drawing.image, path);
    }
    fmt::print("{}\n", args.file);
}

}  // namespace

void add_draw_command(CLI::App& app) {
    auto args = std::make_shared<DrawArgs>();
    auto* command = app.add_subcommand("draw", "Draw one image with one method");
    add_one_scene_options(*command, args->scene);
    CommandRows rows(*command);
    rows.text("-o,--output", args->file, "FILE", "PNG or EXR file to write")->required();
    add_one_method_option(*command, args->methods, kDrawnMethod);
    add_set_option(*command, args->settings, "A parameter of the method: key=value");
    args->options.add_to(*command,
                         {"grid.presets"},
                         "A method with settings of its own, as inkbench tune writes it: a TOML "
                         "file, instead of --method");
    rows.text("--view", args->view, "NAME", "Name of the view (default: the first)");
    args->options.add_to(*command, experiment::view_rows());
    add_look_options(*command, args->looks);
    // clang-format off
    rows.flag("--response,--strength", args->edge_response,
              "Write the edge responses (grey) instead of the image, for inkbench score; an EXR "
              "has both anyway");
    rows.flag("--no-lines", args->no_lines, "Write the shading alone");
    rows.text("--layer", args->layer, "packed|filtered|depth|normal|ids|edges",
              "Write one of the method's internal buffers instead; an EXR has all of them");
    // clang-format on
    args->options.add_to(*command, {"grid.threads"}, "Threads of the method");
    args->options.add_to(*command, {"measure.skips_off"});
    command->footer(
        "Example: inkbench draw torus --method decaudin --shading toon --antialias 4 -o torus.png\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([args] { run_draw(*args); });
}

}  // namespace ink::cli
