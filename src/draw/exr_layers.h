#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "draw/drawing.h"
#include "harness/suite/suite.h"
#include "harness/truths/tracing.h"
#include "method/method_config.h"
#include "truth/truth.h"

namespace ink::draw {

/// What the EXR of a truth calls the share of each pixel that its lines cover, and their width.
inline constexpr const char* kCoverageChannel = "coverage.Y";
inline constexpr const char* kLineWidthAttribute = "ink:line_width_px";

/// Where a truth comes from, as its file says it.
struct TruthOrigin {
    const harness::SceneViews& scene_views;  ///< has the traced view first
    truth::TruthOptions options = {};
    std::string command = {};  ///< that traced it, without size and output; "" if it is not known
};

/// Writes a truth as a multi-channel OpenEXR file.
///
/// Channels: `R G B` (HALF, linear light) the classes in colour, `Z` (FLOAT) the distance along the
/// view direction, infinity before the sky; `class.label` (UINT) the labels, `class.below_crease`
/// (UINT) 1 at intersections that bend by less than the crease angle, `coverage.Y` (FLOAT) the
/// share of each pixel that all curves cover, drawn score::kLineWidth_px wide, `crack.right` and
/// `crack.below` (UINT) the classes of Cracks, `id.triangle` and `id.patch`
/// (UINT, 2^32-1 for the sky), `facing.Y` (FLOAT) |cos| between facet normal and ray, `sampled.Y`
/// and `exact_corner.Y` (HALF) 0 or 1. What the truth was traced without is left out. The header
/// names scene, view, camera (`worldToCamera`, eye, field of view, near), crease angle, whose
/// creases count, ignore label, band, width of the covering lines, command, program and commit.
///
/// Throws core::Error if the file cannot be written.
void write_truth_exr(const TruthOrigin& truth_origin,
                     const truth::Truth& truth,
                     const std::filesystem::path& path);

/// Writes the labels that count as an 8-bit grey PNG of class numbers: a truth of a few kB. Its
/// text chunks have what the header of the EXR has, less program, commit and matrix, so that the
/// same truth is the same file; and in `ink:below_crease_px` how many pixels are intersections
/// below the crease angle that count.
///
/// Throws core::Error if the file cannot be written.
void write_truth_png(const TruthOrigin& truth_origin,
                     const harness::ViewTruth& truth,
                     const std::filesystem::path& path);

/// Writes a drawing as a multi-channel OpenEXR file: `R G B` (HALF, linear light) the finished
/// image, `shading.R shading.G shading.B` (the same) what lies under the lines, unless that is
/// paper, `response.Y` (HALF, k/255) the edge responses of the lines, and of each of the method's
/// layers `NAME.R NAME.G NAME.B` (as the image); the header as above, and the method with its
/// parameters.
void write_drawing_exr(const harness::SceneViews& scene_views,
                       const method::MethodConfig& config,
                       const Drawing& drawing,
                       const std::vector<method::Layer>& layers,
                       const std::filesystem::path& path);

}  // namespace ink::draw
