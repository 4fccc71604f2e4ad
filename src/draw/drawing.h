#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/param.h"
#include "draw/error_image.h"
#include "edge/edge_image.h"
#include "harness/suite/suite.h"
#include "method/method.h"
#include "method/method_config.h"
#include "raster/skips.h"
#include "shade/compose.h"
#include "shade/shading.h"

namespace ink::draw {

inline constexpr int kMostAntialias = 8;
inline constexpr double kMostLineWidth_px = 64;

/// How one picture is drawn: what lies under the lines, and how lines look.
struct DrawOptions {
    std::optional<shade::Style> shading = {};  ///< none: paper
    // Colours; unless given the default ink, white, and a light grey (under strokes the paper's).
    std::optional<glm::u8vec3> ink = {};
    std::optional<glm::u8vec3> paper = {};
    std::optional<glm::u8vec3> surface = {};
    /// Lines are thinned and widened to this; 0 leaves them as the method draws them.
    double line_width_px = 0;
    int antialias = 1;  ///< all is drawn at n x n the size and averaged
    shade::DitherFormat dither = shade::DitherFormat::none;
    int threads = 1;
    raster::SkipSet skips = {};
};

/// A drawing at the size of its view.
struct Drawing {
    edge::EdgeImage edge_responses;  ///< what the lines are drawn from, averaged
    RgbImage image;                  ///< lines over shading or paper, dithered if asked for
    RgbImage shading;                ///< without lines; empty if there is no shading
};

/// Draws the first view of `scene_views` with one method; not timed, not scored.
///
/// Drawn at n x n the size, a method's lines would come out n times thinner: unless a width is
/// asked for, they are widened by n - 1 samples, so that the thinnest are one pixel wide. A method
/// that draws ink draws it once, at the view's size and as wide as is asked for, as far as its
/// `width_px` goes; it is laid over the averaged shading in linear light. The picture depends
/// neither on `threads` nor on `skips`. Throws core::Error (where = "--antialias") if n x n the
/// size is too large.
[[nodiscard]] Drawing make_drawing(const harness::SceneViews& scene_views,
                                   const method::MethodConfig& config,
                                   const DrawOptions& options);

/// Writes a finished drawing as PNG, which says how its ink is mixed. Throws core::Error if the
/// file cannot be written.
void write_drawing(const RgbImage& image, const std::filesystem::path& path);

/// What the method has inside on the first view of `scene_views`, at the view's size; empty for
/// methods that show nothing. Of the options threads and skips alone are read, and change nothing.
[[nodiscard]] std::vector<method::Layer> draw_layers(const harness::SceneViews& scene_views,
                                                     const method::MethodConfig& config,
                                                     const DrawOptions& options);

/// The one of draw_layers that is called `name`. Throws core::Error (where = "--layer") that names
/// the method's layers if there is none.
[[nodiscard]] method::Layer draw_layer(const harness::SceneViews& scene_views,
                                       const method::MethodConfig& config,
                                       const std::string& name,
                                       const DrawOptions& options);

}  // namespace ink::draw
