#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands/commands.h"
#include "cli/json_values.h"
#include "cli/options/command_rows.h"
#include "cli/options/draw_options.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/place.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "experiment/options/option_table.h"
#include "harness/cells/cell.h"
#include "harness/images/view_images.h"
#include "import/rest_alone.h"
#include "methods/method_configs.h"
#include "studies/timedemo.h"

namespace ink::cli {
namespace {

struct TimedemoArgs {
    ExperimentOptions asked;
    SceneOptions scene;
    std::string view;
    std::vector<std::string> methods;
    std::vector<std::string> settings;
    int frames = 60;
    std::string out;
    bool json = false;
};

nlohmann::ordered_json rates_json(const harness::SceneViews& scene_views,
                                  const studies::TimedemoOptions& options,
                                  const std::vector<studies::DemoFrame>& frames) {
    const scene::View& view = scene_views.views.front();
    const auto rate_json = [](const studies::DemoRate& rate) -> nlohmann::ordered_json {
        return {{"path", rate.path},
                {"method", rate.method},
                {"drawn", rate.drawn},
                {"cached", rate.is_cached},
                {"fps", rate.fps},
                {"low_fps", rate.low_fps},
                {"high_fps", rate.high_fps}};
    };
    return {{"scene", scene_views.scene.name},
            {"width", view.width_px},
            {"height", view.height_px},
            {"threads", options.threads},
            {"frames", options.frames},
            {"lights", studies::has_own_lights(scene_views) ? "file" : "studio"},
            {"rates", list_of<nlohmann::ordered_json>(studies::timedemo_rates(frames), rate_json)}};
}

void run_timedemo(const TimedemoArgs& args) {
    const experiment::Experiment asked = args.asked.read();
    studies::TimedemoOptions options;
    options.configs = methods::make_configs(method_list(args.methods), args.settings);
    options.threads = asked.threads.front();
    options.skips = harness::without_skips({}, asked.compare.skips_off);
    options.seed = asked.seed;
    options.frames = args.frames;
    const harness::ViewRequest request = views_of(asked);
    if (request.time_s || request.frame) {
        throw core::Error(
            "--time", "a time demo shows all of an animation", "no --time or --frame");
    }
    const harness::SceneViews scene_views =
        harness::load_one_view(one_scene(args.scene, "timedemo"), args.view, request);
    import::check_motion_is_read(scene_views.scene, "timedemo");
    print_notes(scene_views);
    if (!args.out.empty()) harness::make_out_folder(args.out);
    const char* what_is_left = "nothing is written";
    const core::InterruptGuard guard(what_is_left);
    const auto frames = studies::run_timedemo(scene_views, options);
    if (core::is_interrupted()) {
        end_interrupted(what_is_left);
    }
    if (args.json) {
        fmt::print("{}\n", rates_json(scene_views, options, frames).dump(2));
    } else {
        fmt::print("{}\n{}\n{}",
                   studies::timedemo_heading(scene_views, options),
                   studies::timedemo_table(frames),
                   studies::timedemo_legend());
    }
    if (args.out.empty()) return;
    const auto path = std::filesystem::path(args.out) / "timedemo.csv";
    studies::write_timedemo(scene_views, frames, path);
    if (!args.json) fmt::print("{}\n", path.string());
}

}  // namespace

void add_timedemo_command(CLI::App& app) {
    auto args = std::make_shared<TimedemoArgs>();
    auto* command = app.add_subcommand(
        "timedemo", "Time an animation: frames per second plain, shaded, with lines and toon");
    add_one_scene_options(*command, args->scene);
    add_method_options(*command, args->methods);
    add_set_option(*command, args->settings);
    CommandRows rows(*command);
    rows.number("--frames", args->frames, {2, 10000}, "N", "Frames of each camera path");
    rows.text("--view", args->view, "NAME", "View where the camera starts (default: the first)");
    args->asked.add_to(*command, experiment::view_rows());
    args->asked.add_to(*command, {"grid.threads"}, "Threads of a method");
    args->asked.add_to(*command, {"seed"}, "Of the shaking camera");
    args->asked.add_to(*command, {"measure.skips_off"});
    add_out_folder_option(
        *command, args->out, "Folder for timedemo.csv (default: it is not written)");
    rows.flag("--json", args->json, "Print JSON instead of the table");
    add_quiet_option(*command);
    command->footer(
        "Prints frames per second, with a legend below the table.\n"
        "With --views file, a camera that the model moves is followed first (path 'own').\n"
        "Example: inkbench timedemo gear --methods mote4,edge_hash --frames 30\n"
        "Exit codes: 0 done, 2 bad input, 130 interrupted.");
    command->callback([args] { run_timedemo(*args); });
}

}  // namespace ink::cli
