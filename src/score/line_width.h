#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "edge/edge_image.h"
#include "score/moments.h"
#include "score/score.h"
#include "truth/curve.h"

namespace ink::score {

/// A place on a visible curve at which a drawn line's width is measured.
struct WidthProbe {
    double x_px = 0;
    double y_px = 0;
    double normal_x = 0;  ///< unit
    double normal_y = 0;
    std::uint8_t label = 0;  ///< truth::LineClass of the curve
};

/// One probe for each pixel of the curves' whole length, in their order (what a curve has left over
/// counts towards the next, so that many short ones have as many as a long one); those in the band
/// or in ignored pixels are left out. Made once a view. Reads `band_px` of the options; `truth` is
/// of the curves' image.
[[nodiscard]] std::vector<WidthProbe> place_probes(std::span<const truth::Curve> curves,
                                                   const ScoringTruth& truth,
                                                   const ScoreOptions& options);

/// How wide lines are drawn along the true curves.
struct Widths {
    Moments all;                     ///< px
    std::array<Moments, 8> classes;  ///< by truth::LineClass
    std::int64_t n_missed = 0;       ///< probes that met no line
    std::int64_t n_open = 0;  ///< probes whose line does not end: a crossing line, or a filled area
};

/// Measures the width of what is drawn (before any thinning) across the true curves.
///
/// The width at a probe is the length, in px, of the piece of the curve's normal that lies in drawn
/// pixels without a gap and holds the probe; if the probe's own pixel is not drawn, of the first
/// such piece met within 2 px of it to either side, the nearer one. A piece that does not end
/// within 8 px of the probe has no width. So a band of w rows or columns is w px wide, a
/// one-pixel diagonal 0.71 px, and the mean over a long line is its drawn area over its length
/// whatever its angle.
///
/// `drawn` is of the image in which the probes were placed.
[[nodiscard]] Widths measure_widths(const edge::Mask& drawn, std::span<const WidthProbe> probes);

}  // namespace ink::score
