#pragma once

#include <filesystem>

#include "edge/edge_image.h"
#include "lab/entrants.h"
#include "lab/error_picture.h"
#include "lab/suite.h"
#include "truth/truth.h"

namespace ink::lab {

/// What lies under the lines of a drawn picture.
enum class Shading {
    none,     ///< paper
    gouraud,  ///< the scene's lamps, per vertex
};

/// The strengths that one method draws of the first view of `subject`; not timed, not scored.
/// The picture depends neither on `threads` nor on `skips`.
[[nodiscard]] edge::EdgeImage draw_strengths(const Subject& subject,
                                             const Entrant& entrant,
                                             int threads,
                                             const raster::SkipSet& skips = {});

/// A finished drawing: black lines where a strength reaches the entrant's threshold, over white
/// paper or shading.
[[nodiscard]] RgbImage compose_drawing(const Subject& subject,
                                       const Entrant& entrant,
                                       const edge::EdgeImage& strengths,
                                       Shading shading);

/// Writes a finished drawing as PNG. Throws core::Error if the file cannot be written.
void write_drawing(const Subject& subject,
                   const Entrant& entrant,
                   const edge::EdgeImage& strengths,
                   Shading shading,
                   const std::filesystem::path& path);

/// Writes bare strengths as an 8-bit grey PNG, which `inkbench score` takes.
void write_strengths(const edge::EdgeImage& strengths, const std::filesystem::path& path);

/// Writes a truth's labels as an 8-bit grey PNG of class numbers, which `inkbench score` takes, or
/// as a picture with a colour per class on white.
void write_truth_labels(const truth::Truth& truth, const std::filesystem::path& path);
void write_truth_picture(const truth::Truth& truth, const std::filesystem::path& path);

}  // namespace ink::lab
