#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "harness/suite/suite.h"
#include "truth/model.h"

namespace ink::cli {

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

void add_drawing_options(CLI::App& command, DrawingOptions& options);

/// Before any work. Throws core::Error for options that say nothing, a file that cannot be written,
/// and where several views are asked for, none by `view_name`, and a file has room for one.
void check_drawing_options(const DrawingOptions& options,
                           const harness::ViewRequest& request,
                           const std::string& view_name);

/// Writes a drawing per view into the folder, which is there, or that of the first view into a
/// file, with a line on stdout each, and one on stderr for a sheet of an odd size. A view that is
/// too large ends the program.
void write_drawings(truth::SceneModel& model,
                    const harness::SceneViews& scene_views,
                    const DrawingOptions& options);

}  // namespace ink::cli
