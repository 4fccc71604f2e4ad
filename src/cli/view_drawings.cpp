#include "cli/view_drawings.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "cli/options/options.h"
#include "cli/traced_view.h"
#include "core/error.h"
#include "core/whole_file.h"
#include "draw/line_drawing.h"
#include "harness/view_images.h"
#include "truth/drawn_lines.h"

namespace ink::cli {
namespace {

constexpr double kLeastSheet_mm = 1, kMostSheet_mm = 10000;

void check_sheet(double width_mm, const char* option) {
    if (width_mm >= kLeastSheet_mm && width_mm <= kMostSheet_mm) return;
    throw core::Error(option,
                      fmt::format("no sheet is {:g} mm wide", width_mm),
                      fmt::format("{:g}..{:g}", kLeastSheet_mm, kMostSheet_mm));
}

/// A parallel view has a scale; one in perspective is as wide as a browser shows it.
double sheet_width_mm(const scene::View& view, const DrawingOptions& options) {
    if (options.sheet_width_mm) return *options.sheet_width_mm;
    const scene::Camera& camera = view.camera;
    if (camera.is_parallel()) {
        const double units = camera.height_world * view.width_px / view.height_px;
        const double width_mm = units * options.mm_per_unit.value_or(1);
        check_sheet(width_mm, "--scale");
        return width_mm;
    }
    if (options.mm_per_unit) {
        throw core::Error("--scale",
                          fmt::format("view '{}' is in perspective", camera.name),
                          "parallel views (--projection parallel), or --sheet-width");
    }
    return draw::usual_sheet_mm(view.width_px);
}

truth::DrawnLines lines_of(truth::SceneModel& model, const scene::View& view, bool hidden) {
    const truth::TruthOptions& options = model.options();
    try {
        return truth::trace_drawn_lines(
            model.model(),
            view,
            {.threads = options.threads, .limits = options.limits, .progress = options.progress},
            hidden ? truth::Hidden::keep : truth::Hidden::leave_out);
    } catch (const truth::TooLarge& reason) {
        end_too_large(model.scene().name, reason);
    }
}

}  // namespace

void add_drawing_options(CLI::App& command, DrawingOptions& options) {
    command
        .add_option("--drawing",
                    options.place,
                    "SVG for print, in mm, of long lines in a group per class: a name in .svg for "
                    "one view, else a folder, which gets VIEW.svg of each view")
        ->type_name("FILE|DIR");
    command.add_flag("--hidden", options.hidden, "Hidden lines too, dashed, in --drawing");
    command
        .add_option("--sheet-width",
                    options.sheet_width_mm,
                    "Width of a --drawing (default: by --scale, in perspective 96 px an inch)")
        ->type_name("MM");
    command
        .add_option("--scale",
                    options.mm_per_unit,
                    "Length in a --drawing of a unit of the model, in parallel views (default: 1)")
        ->type_name("MM");
}

void check_drawing_options(const DrawingOptions& options,
                           const harness::ViewRequest& request,
                           const std::string& view_name) {
    if (!options.place) {
        for (const auto& [is_asked, name] : {std::pair{options.hidden, "--hidden"},
                                             {options.sheet_width_mm.has_value(), "--sheet-width"},
                                             {options.mm_per_unit.has_value(), "--scale"}})
            if (is_asked) throw core::Error(name, "there is no drawing to show it", "--drawing");
        return;
    }
    if (options.sheet_width_mm) check_sheet(*options.sheet_width_mm, "--sheet-width");
    if (options.mm_per_unit && options.sheet_width_mm)
        throw core::Error("--scale", "there is a --sheet-width beside it", "one of the two");
    if (options.mm_per_unit && !(*options.mm_per_unit > 0)) {
        throw core::Error("--scale",
                          fmt::format("a unit cannot be {:g} mm long", *options.mm_per_unit),
                          "a length above 0");
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
    check_output_path(*options.place, {".svg"});
}

void write_drawings(truth::SceneModel& model,
                    std::span<const scene::View> views,
                    const DrawingOptions& options) {
    const std::string& scene = model.scene().name;
    if (!options.is_folder()) views = views.first(1);
    std::vector<double> widths_mm;  // all of them are fit to be drawn before one is
    for (const scene::View& view : views)
        widths_mm.push_back(sheet_width_mm(view, options));
    for (std::size_t v = 0; v < views.size(); ++v) {
        const scene::View& view = views[v];
        const truth::DrawnLines lines = lines_of(model, view, options.hidden);
        std::filesystem::path path = *options.place;
        if (options.is_folder()) path /= harness::file_name(view.camera.name) + ".svg";
        core::write_whole_file(path, draw::line_drawing(lines, scene, view, widths_mm[v]));
        const std::string hidden =
            options.hidden ? fmt::format(", {} hidden", lines.hidden.size()) : "";
        const std::string scale = view.camera.is_parallel()
                                      ? fmt::format(", {:.4g} mm a unit",
                                                    widths_mm[v] / view.width_px * view.height_px /
                                                        view.camera.height_world)
                                      : "";
        fmt::print("{} {}: {}, {:.4g} x {:.4g} mm{}, {} visible{} lines\n",
                   scene,
                   view.camera.name,
                   path.string(),
                   widths_mm[v],
                   widths_mm[v] * view.height_px / view.width_px,
                   scale,
                   lines.visible.size(),
                   hidden);
    }
}

}  // namespace ink::cli
