#include "cli/view_drawings.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "cli/options/command_rows.h"
#include "cli/options/options.h"
#include "cli/traced_view.h"
#include "core/error.h"
#include "core/named.h"
#include "core/param.h"
#include "core/whole_file.h"
#include "draw/line_drawing.h"
#include "draw/sheet.h"
#include "harness/images/view_images.h"

namespace ink::cli {
namespace {

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

}  // namespace

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

}  // namespace ink::cli
