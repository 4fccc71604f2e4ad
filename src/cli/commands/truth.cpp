#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/place.h"
#include "cli/traced_view.h"
#include "core/error.h"
#include "core/named.h"
#include "core/parallel.h"
#include "core/param.h"
#include "core/split_list.h"
#include "core/whole_file.h"
#include "draw/error_image.h"
#include "draw/exr_layers.h"
#include "draw/line_drawing.h"
#include "draw/outline_svg.h"
#include "draw/sheet.h"
#include "experiment/experiment_plan.h"
#include "experiment/options/option_table.h"
#include "harness/images/view_images.h"
#include "harness/suite/suite.h"
#include "harness/truths/tracing.h"
#include "image_io/image_file.h"
#include "inspect/crosscheck_report.h"
#include "truth/model.h"

namespace ink::cli {
namespace {

/// Which drawings `truth` writes.
struct DrawingOptions {
    std::optional<std::string> place;  ///< a file (.svg, .dxf) of one view, or a folder
    bool hidden = false;
    std::optional<double> sheet_width_mm;
    std::optional<std::string> paper;  ///< "A4": cropped to the lines, and fitted
    std::optional<std::string> scale;  ///< of parallel views: "1:2", or mm of a unit

    [[nodiscard]] bool is_folder() const {
        if (!place) return false;
        const std::filesystem::path path(*place);
        return path.extension().empty() || std::filesystem::is_directory(path);
    }
};

constexpr std::pair kSheet_mm{1.0, 10000.0};

void check_scaled_sheet(double width_mm) {
    const auto [least_mm, most_mm] = kSheet_mm;
    if (width_mm >= least_mm && width_mm <= most_mm) return;
    throw core::Error("--scale",
                      fmt::format("no sheet is {:g} mm wide", width_mm),
                      fmt::format("{:g}..{:g}", least_mm, most_mm));
}

std::optional<double> asked_scale(const DrawingOptions& options) {
    return options.scale ? draw::parse_scale(*options.scale) : std::nullopt;
}

/// A parallel view has a scale; one in perspective is as wide as a browser shows it.
draw::Sheet image_sheet(const scene::View& view, const DrawingOptions& options) {
    if (options.sheet_width_mm) return draw::image_sheet(view, *options.sheet_width_mm);
    const scene::Camera& camera = view.camera;
    if (!camera.is_parallel()) return draw::image_sheet(view, draw::usual_sheet_mm(view.width_px));
    const double units = camera.height_world * view.width_px / view.height_px;
    const double width_mm = units * asked_scale(options).value_or(1);
    check_scaled_sheet(width_mm);
    return draw::image_sheet(view, width_mm);
}

/// What can be said before a line is traced.
void check_view(const scene::View& view, const DrawingOptions& options) {
    if (options.scale && !view.camera.is_parallel()) {
        throw core::Error("--scale",
                          fmt::format("view '{}' is in perspective", view.camera.name),
                          "parallel views (--projection parallel), or --sheet-width");
    }
    if (!options.paper) (void)image_sheet(view, options);
}

draw::Sheet sheet_of(const scene::View& view,
                     const truth::TracedLines& lines,
                     const DrawingOptions& options) {
    if (!options.paper) return image_sheet(view, options);
    const draw::Paper& paper = *core::find_named(draw::kPapers, *options.paper);
    if (const auto sheet = draw::paper_sheet(paper, view, lines, asked_scale(options)))
        return *sheet;
    throw core::Error("--scale",
                      fmt::format("at {} view '{}' does not fit on {} with {:g} mm free all round",
                                  *options.scale,
                                  view.camera.name,
                                  paper.name,
                                  draw::kBorder_mm),
                      "a smaller scale, a larger --sheet, or --sheet without a scale");
}

truth::TracedLines lines_of(truth::SceneModel& model, const scene::View& view, bool hidden) {
    try {
        return draw::trace_drawn_lines(model.model(),
                                       view,
                                       model.options(),
                                       hidden ? truth::Hidden::keep : truth::Hidden::leave_out);
    } catch (const truth::TooLarge& reason) {
        end_too_large(model.scene().name, reason);
    }
}

void say_what_is_drawn(const std::string& what,
                       const std::filesystem::path& path,
                       const draw::Sheet& sheet,
                       const std::string& lines) {
    if (const std::string doubt = draw::doubt_of_size(sheet); !doubt.empty()) {
        fmt::print(stderr,
                   "inkbench: {}: its sheet of {:.4g} x {:.4g} mm is {}; --sheet A4 or another "
                   "--scale fits it\n",
                   what,
                   sheet.width_mm,
                   sheet.height_mm,
                   doubt);
    }
    fmt::print("{}: {}, {:.4g} x {:.4g} mm{}\n",
               what,
               path.string(),
               sheet.width_mm,
               sheet.height_mm,
               lines);
}

void write_drawing(truth::SceneModel& model,
                   const scene::View& view,
                   const DrawingOptions& options,
                   const std::string& up) {
    const std::string& scene = model.scene().name;
    truth::TracedLines traced = lines_of(model, view, options.hidden);
    const draw::Sheet sheet = sheet_of(view, traced, options);
    draw::remove_covered(traced, draw::same_line_px(sheet));
    const draw::DrawnLines lines = draw::joined_by_class(std::move(traced));
    std::filesystem::path path = *options.place;
    if (options.is_folder()) path /= harness::file_name(view.camera.name) + ".svg";
    const auto drawing = path.extension() == ".dxf" ? draw::dxf_drawing : draw::line_drawing;
    core::write_whole_file(path, drawing(lines, scene, view, sheet));
    std::string said;
    if (view.camera.is_parallel()) {
        const double scale = draw::mm_per_unit(sheet, view);
        said = fmt::format(", scale {} ({:.4g} mm a unit)", draw::scale_text(scale), scale);
    }
    said += up + fmt::format(", {} visible", lines.visible.size());
    if (options.hidden) said += fmt::format(", {} hidden", lines.hidden.size());
    say_what_is_drawn(scene + " " + view.camera.name, path, sheet, said + " lines");
}

void add_drawing_options(CLI::App& command, DrawingOptions& options) {
    CommandRows rows(command);
    // clang-format off
    rows.text("--drawing", options.place, "FILE|DIR",
              "Drawing for print, in mm, of long lines in a group per class: a name in .svg or "
              ".dxf (release 12) for one view, else a folder, which gets VIEW.svg of each");
    rows.flag("--hidden", options.hidden, "Hidden lines too, dashed, in --drawing");
    rows.number("--sheet-width", options.sheet_width_mm, kSheet_mm, "MM",
                "Width of a --drawing (default: by --scale, in perspective 96 px an inch)");
    rows.text("--sheet", options.paper, "A4..A0",
              "Paper of a --drawing, which is cropped to its lines and fitted, in parallel views "
              "at 1, 2 or 5 times a power of ten");
    rows.text("--scale", options.scale, "N:N|MM",
              "Scale of a --drawing in parallel views, where a unit of the model counts as 1 mm: "
              "1:2, 5:1, or the mm of a unit (default: 1)");
    // clang-format on
}

/// Before any work. Throws core::Error for options that say nothing, a file that cannot be written,
/// and where several views are asked for, none by `view_name`, and a file has room for one.
void check_drawing_options(const DrawingOptions& options,
                           const harness::ViewRequest& request,
                           const std::string& view_name) {
    if (!options.place) {
        for (const auto& [is_asked, name] : {std::pair{options.hidden, "--hidden"},
                                             {options.sheet_width_mm.has_value(), "--sheet-width"},
                                             {options.paper.has_value(), "--sheet"},
                                             {options.scale.has_value(), "--scale"}})
            if (is_asked) throw core::Error(name, "there is no drawing to show it", "--drawing");
        return;
    }
    for (const auto& [is_asked, name] :
         {std::pair{options.scale.has_value(), "--scale"}, {options.paper.has_value(), "--sheet"}})
        if (is_asked && options.sheet_width_mm)
            throw core::Error(name, "there is a --sheet-width beside it", "one of the two");
    if (options.scale && !asked_scale(options)) {
        throw core::Error("--scale",
                          fmt::format("'{}' is no scale", *options.scale),
                          "1:2, 5:1, or the mm of a unit, above 0");
    }
    if (options.paper && core::find_named(draw::kPapers, *options.paper) == nullptr) {
        throw core::Error("--sheet",
                          fmt::format("there is no paper '{}'", *options.paper),
                          core::known_names(core::names_of(draw::kPapers), *options.paper));
    }
    if (options.is_folder()) return;
    const std::size_t views = std::max({static_cast<std::size_t>(request.orbit_count.value_or(1)),
                                        request.directions.size(),
                                        request.cameras.size()});
    if (views > 1 && view_name.empty()) {
        throw core::Error(*options.place,
                          fmt::format("one file has no room for {} views", views),
                          "a folder, which gets a file of each, or --view NAME");
    }
    check_output_path(*options.place, {".svg", ".dxf"});
}

/// Writes a drawing per view into the folder, which is there, or that of the first view into a
/// file, with a line on stdout each, and one on stderr for a sheet of an odd size. A view that is
/// too large ends the program.
void write_drawings(truth::SceneModel& model,
                    const harness::SceneViews& scene_views,
                    const DrawingOptions& options) {
    std::span<const scene::View> views = scene_views.views;
    if (!options.is_folder()) views = views.first(1);
    std::string up;
    if (scene_views.has_named_views) up = fmt::format(", {} up", name(scene_views.up));
    for (const scene::View& view : views)  // all of them are fit to be drawn before one is
        check_view(view, options);
    for (const scene::View& view : views)
        write_drawing(model, view, options, up);
}

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
