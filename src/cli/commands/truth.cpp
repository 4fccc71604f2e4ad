#include <fmt/format.h>

#include <memory>
#include <optional>

#include "cli/commands/commands.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/options/scene_options.h"
#include "cli/place.h"
#include "cli/traced_view.h"
#include "cli/view_drawings.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/split_list.h"
#include "core/whole_file.h"
#include "draw/error_image.h"
#include "draw/exr_layers.h"
#include "draw/outline_svg.h"
#include "experiment/experiment_plan.h"
#include "experiment/options/option_table.h"
#include "harness/images/out_folder.h"
#include "harness/images/view_images.h"
#include "harness/truths/tracing.h"
#include "image_io/image_file.h"
#include "inspect/crosscheck_report.h"

namespace ink::cli {
namespace {

experiment::Experiment usual_truth() {
    experiment::Experiment usual;
    usual.intersections = score::Intersections::all;
    usual.threads = {core::hardware_threads()};
    return usual;
}

struct TruthArgs {
    SceneOptions scene;
    std::string view;
    std::optional<std::string> file;
    std::optional<std::string> svg;
    std::optional<std::string> image;
    std::optional<std::string> disagreement;
    bool crosscheck = false;
    DrawingOptions drawing;
    CacheOptions cache;
    ExperimentOptions options{usual_truth()};

    /// Whether drawings are all that was asked for: they need the lines alone.
    [[nodiscard]] bool is_drawing_alone() const {
        return drawing.place && !file && !svg && !image && !crosscheck;
    }
};

/// The one view, or all for a folder of drawings: the first is the one that is traced.
harness::SceneViews asked_views(const TruthArgs& args, const harness::ViewRequest& request) {
    const std::string scene = one_scene(args.scene, "truth");
    if (args.drawing.is_folder() && args.view.empty())
        return std::move(harness::load_scenes({scene}, request).front());
    return harness::load_one_view(scene, args.view, request);
}

void draw_alone(const TruthArgs& args,
                const harness::SceneViews& scene_views,
                truth::TruthOptions options) {
    print_notes(scene_views);
    harness::report_progress(options);
    truth::SceneModel model(scene_views.scene, options);
    write_drawings(model, scene_views, args.drawing);
}

/// In the format that the name asks for.
void write_truth(const TracedView& traced,
                 const draw::TruthOrigin& origin,
                 const std::filesystem::path& path) {
    if (path.extension() == ".exr") {
        draw::write_truth_exr(origin, traced.truth.traced, path);
    } else if (path.extension() == ".svg") {
        core::write_whole_file(
            path,
            draw::outline_svg(traced.truth.traced, traced.scene_views.scene.name, traced.view()));
    } else {
        draw::write_truth_png(origin, traced.truth, path);
    }
}

/// Where the image of what truth and cross-check disagree on goes unless it is said; makes the
/// folder.
std::string default_disagreement(const scene::Scene& scene, const scene::View& view) {
    const auto folder = std::filesystem::path("inkbench-out") / "crosscheck";
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) {
        throw core::Error(folder.string(),
                          "this folder cannot be made",
                          "a writable working folder, or --disagreement FILE");
    }
    const std::string name = harness::file_name(scene.name + "_" + view.camera.name) + ".png";
    const auto path = folder / name;
    check_output_path(path, {".png"});
    return path.string();
}

/// Holds the truth against its cross-check; false if they disagree.
bool check_truth(const TruthArgs& args, TracedView& traced) {
    const truth::Truth& truth = traced.truth.traced;
    const scene::View& view = traced.view();
    const harness::Crosscheck check =
        harness::cached_crosscheck(traced.model, view, truth, cache_folder(args.cache));
    inspect::write_disagreement(view, truth.curves, check.agreement, *args.disagreement);
    fmt::print("{}disagreements: {}\n",
               inspect::crosscheck_summary(check, truth.curves),
               *args.disagreement);
    const bool is_agreed = check.agreement.is_agreed();
    if (!is_agreed) {
        fmt::print(stderr,
                   "inkbench: truth and cross-check agree on less than 99.9 % of a class\n");
    }
    return is_agreed;
}

/// The command without what does not say which truth it is, and without size and file, which a
/// reader of it gives anew.
std::string command_of_truth(const CLI::App& command) {
    return recorded_command(
        command,
        core::split_list("--size, --output, --svg, --image, --crosscheck, --disagreement, "
                         "--drawing, --hidden, --sheet, --sheet-width, --scale, --threads, "
                         "--cache, --no-cache"));
}

void run_truth(TruthArgs args, const CLI::App& command) {
    if (args.disagreement && !args.crosscheck) {
        throw core::Error("--disagreement", "there is no cross-check to disagree", "--crosscheck");
    }
    const experiment::Experiment asked = args.options.read();
    harness::TraceOptions options = experiment::trace_of(asked, cache_folder(args.cache));
    options.truth.threads = asked.threads.front();
    if (args.file) check_output_path(*args.file, {".png", ".exr", ".svg"});
    if (args.svg) check_output_path(*args.svg, {".svg"});
    for (const auto& file : {args.image, args.disagreement}) {
        if (file) check_output_path(*file, {".png"});
    }
    const harness::ViewRequest request = views_of(asked);
    check_drawing_options(args.drawing, request, args.view);
    harness::SceneViews scene_views = asked_views(args, request);
    if (args.drawing.is_folder()) harness::make_out_folder(*args.drawing.place);
    if (args.is_drawing_alone()) return draw_alone(args, scene_views, options.truth);
    TracedView traced(std::move(scene_views), options);
    const scene::Scene& scene = traced.scene_views.scene;
    if (args.crosscheck && !args.disagreement) {
        args.disagreement = default_disagreement(scene, traced.view());
    }
    const draw::TruthOrigin origin{traced.scene_views, options.truth, command_of_truth(command)};
    if (args.file) write_truth(traced, origin, *args.file);
    if (args.svg) write_truth(traced, origin, *args.svg);
    if (args.drawing.place) write_drawings(traced.model, traced.scene_views, args.drawing);
    if (args.image)
        image_io::write_png(draw::truth_image(traced.truth.counted_labels()), *args.image);
    fmt::print("{} {}\n{}",
               scene.name,
               traced.view().camera.name,
               harness::truth_summary(traced.truth.traced));
    if (args.crosscheck && !check_truth(args, traced)) throw CLI::RuntimeError(1);
}

}  // namespace

void add_truth_command(CLI::App& app) {
    auto args = std::make_shared<TruthArgs>();
    auto* command = app.add_subcommand("truth", "Trace the exact outline of one view");
    add_one_scene_options(*command, args->scene);
    CommandRows rows(*command);
    // clang-format off
    rows.text("-o,--output", args->file, "FILE",
              "By its ending: .png of class numbers (1 contour, 2 boundary, 3 crease, 4 "
              "intersection, 5 seam, 7 ignore), .exr of all layers, .svg of the curves");
    rows.text("--svg", args->svg, "FILE",
              "SVG of the curves, sub-pixel, with their attributes");
    rows.text("--image,--picture", args->image, "FILE",
              "PNG with a colour per class, for people; score takes the one of -o");
    rows.flag("--crosscheck,--witness", args->crosscheck,
              "Compare the curves with dense sampling");
    rows.text("--disagreement", args->disagreement, "FILE",
              "PNG of the lines that only one of the two has, with --crosscheck (default: "
              "inkbench-out/crosscheck/SCENE_VIEW.png)");
    // clang-format on
    add_drawing_options(*command, args->drawing);
    rows.text("--view", args->view, "NAME", "Name of the view (default: the first)");
    args->options.add_to(*command, experiment::view_rows());
    args->options.add_to(*command, truth_rows());
    args->options.add_to(*command, {"measure.creases"});
    args->options.add_to(*command, {"grid.threads"}, "Threads that trace");
    add_cache_options(*command, args->cache);
    add_quiet_option(*command);
    command->footer(
        "Example: inkbench truth staircase -o truth.png --image lines.png\n"
        "The .png has a few kB, and says how it wants to be scored, as the .exr does:\n"
        "inkbench score drawn.png truth.png\n"
        "inkbench truth bracket --views front,top,iso --drawing sheets --hidden --sheet A4\n"
        "With --intersections above_crease, those below the crease angle are 7 too, as in "
        "compare.\n"
        "Exit codes: 0 done, 1 the view is too large, or with --crosscheck: agreement below 99.9 % "
        "of "
        "a class; 2 bad input.");
    command->callback([args, command] { run_truth(*args, *command); });
}

}  // namespace ink::cli
