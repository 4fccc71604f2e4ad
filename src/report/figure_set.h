#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/figure_views.h"

namespace ink::report {

/// What charts are drawn from if not from the pictures' own rows.
struct ChartSource {
    std::vector<harness::Row> rows;  ///< of rows.csv
    std::string words;               ///< where they are from, for captions
};

/// The comparison figures of a paper.
struct FigureOptions {
    FigureDrawing drawing;
    std::filesystem::path out;  ///< a folder; made if need be
    /// The methods of the enlarged windows; unless given mote4 and decaudin if both take part, else
    /// the first two.
    std::optional<std::pair<std::string, std::string>> pair = {};
    std::optional<ChartSource> charts = {};
    std::string command;  ///< as the user typed it, for the captions
};

/// What was written.
struct FigureFiles {
    std::vector<std::string> names;  ///< in the folder, in the order of figures.md
    bool is_interrupted = false;
};

/// Draws `scenes` with all methods and writes into `options.out`: strips, buffers and zoom, each
/// as .png and .svg (figure_grids.h), error_time.svg, classes.svg, figure_summary.csv and
/// figure_rows.csv (the numbers of charts and of pictures; rows.csv may be a run's) and figures.md
/// with a caption for each.
///
/// A figure that there is nothing for is left out, and figures.md says why; one of an older run is
/// removed, so that it does not pass for this one's. Every file appears whole or not at all. Throws
/// core::Error, before any work, if the folder cannot be made or `pair` names a method that does
/// not take part.
[[nodiscard]] FigureFiles make_figures(const std::vector<harness::SceneViews>& scenes,
                                       const FigureOptions& options);

}  // namespace ink::report
