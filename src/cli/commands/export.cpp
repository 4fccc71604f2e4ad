#include <fmt/format.h>

#include <memory>

#include "cli/commands/commands.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/place.h"
#include "core/error.h"
#include "core/tables/csv_table.h"
#include "core/whole_file.h"
#include "draw/exr_layers.h"
#include "entrants/view_files.h"
#include "experiment/experiment_plan.h"
#include "experiment/options/option_table.h"
#include "harness/images/view_images.h"
#include "harness/truths/tracing.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;

struct ExportArgs {
    SceneOptions scenes;
    std::string out;
    std::string truth = "train";
    ExperimentOptions options;  ///< of views and the truth
    CacheOptions cache;
};

bool wants_truth(const ExportArgs& args, const scene::Scene& scene) {
    if (args.truth == "all") return true;
    return args.truth == "train" && scene.split == scene::Split::train;
}

/// A view that is too large to trace has no truth, and says so.
void export_truth(const harness::SceneViews& scene_views,
                  truth::SceneModel& model,
                  const harness::TraceOptions& trace,
                  const fs::path& file) {
    try {
        const harness::ViewTruth truth =
            harness::trace_view(model, scene_views.views.front(), trace);
        draw::write_truth_exr({scene_views, trace.truth}, truth.traced, file);
    } catch (const truth::TooLarge& reason) {
        fmt::print(stderr,
                   "inkbench: {}: {} has no truth: too_large: {}\n",
                   scene_views.scene.name,
                   scene_views.views.front().camera.name,
                   reason.what());
    }
}

/// A line per view: its scene, name, size and folder.
std::string export_scene(const ExportArgs& args,
                         const harness::SceneViews& scene_views,
                         const harness::TraceOptions& trace) {
    const scene::Scene& scene = scene_views.scene;
    const fs::path folder = fs::path(args.out) / harness::file_name(scene.name);
    const entrants::ViewFiles meshes = entrants::write_meshes(scene, scene_views.views, folder);
    truth::SceneModel model(scene, trace.truth);
    std::string lines;
    for (const scene::View& view : scene_views.views) {
        const fs::path of_view = folder / harness::file_name(view.camera.name);
        entrants::write_view(scene, view, meshes, trace.truth.crease_rad, of_view);
        if (wants_truth(args, scene))
            export_truth({scene, {view}}, model, trace, of_view / "truth.exr");
        lines += fmt::format("{},{},{},{},{}\n",
                             core::csv_field(scene.name),
                             core::csv_field(view.camera.name),
                             view.width_px,
                             view.height_px,
                             core::csv_field(of_view.lexically_relative(args.out).string()));
    }
    return lines;
}

void run_export(const ExportArgs& args) {
    std::vector<std::string> names = scene_names(args.scenes);
    if (names.empty()) throw core::Error("export", "no scene is named", "scenes or model files");
    const experiment::Experiment asked = args.options.read();
    const harness::TraceOptions trace = experiment::trace_of(asked, cache_folder(args.cache));
    const auto scenes = harness::load_scenes(names, views_of(asked));
    harness::make_out_folder(args.out);
    std::string table = "scene,view,width,height,folder\n";
    for (const harness::SceneViews& scene_views : scenes) {
        print_notes(scene_views);
        table += export_scene(args, scene_views, trace);
    }
    core::write_whole_file(fs::path(args.out) / "views.csv", table);
    fmt::print("{}", table);
}

}  // namespace

void add_export_command(CLI::App& app) {
    auto args = std::make_shared<ExportArgs>();
    auto* command = app.add_subcommand(
        "export", "Write meshes, cameras, buffers and truths of views for programs outside");
    add_scene_options(*command, args->scenes, "Built-in scenes or model files");
    args->options.add_to(*command, experiment::view_rows());
    add_out_folder_option(*command, args->out, "Folder of the exported views")->required();
    CommandRows(*command).choice(
        "--truth",
        args->truth,
        {"train", "all", "none"},
        "Whose truth.exr is written: that of training scenes (train), all, or none");
    args->options.add_to(*command, truth_rows());
    add_cache_options(*command, args->cache);
    add_quiet_option(*command);
    command->footer(
        "DIR/views.csv lists the views. DIR/SCENE has mesh.obj and mesh.glb, DIR/SCENE/VIEW has\n"
        "camera.json (with the conventions in words), ids.png, buffers.exr and truth.exr.\n"
        "Images of these views come back with inkbench compare --entrant NAME=FOLDER.\n"
        "Example: inkbench export torus teapot -o views\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([args] { run_export(*args); });
}

}  // namespace ink::cli
