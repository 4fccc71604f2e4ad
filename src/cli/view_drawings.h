#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>

#include "harness/suite.h"
#include "truth/model.h"

namespace ink::cli {

/// Which drawings `truth` writes.
struct DrawingOptions {
    std::optional<std::string> place;  ///< a file (.svg) of one view, else a folder
    bool hidden = false;
    std::optional<double> sheet_width_mm;

    [[nodiscard]] bool is_folder() const { return place && !place->ends_with(".svg"); }
};

void add_drawing_options(CLI::App& command, DrawingOptions& options);

/// Before any work: makes the folder. Throws core::Error for options that say nothing, a place that
/// cannot be written, and where several views are asked for and a file has room for one.
void check_drawing_options(const DrawingOptions& options, const harness::ViewRequest& request);

/// Writes a drawing per view, or that of the first view into a file, with a line on stdout each. A
/// view that is too large ends the program.
void write_drawings(truth::SceneModel& model,
                    std::span<const scene::View> views,
                    const DrawingOptions& options);

}  // namespace ink::cli
