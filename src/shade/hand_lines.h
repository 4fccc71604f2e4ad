#pragma once

#include <cstdint>

#include "core/image.h"
#include "core/param.h"
#include "shade/line_chains.h"

namespace ink::shade {

/// How a hand draws; lengths in pixels that the user sees.
struct HandParams {
    double jitter_px = 0.8;
    double wave_px = 30;
    double overshoot_px = 4;
    double width_spread = 0.4;
    double taper_px = 10;
    int passes = 1;
    double corner_deg = 45;
    double smooth_px = 1.5;
    double least_px = 3;
};

[[nodiscard]] core::ParamTable<HandParams> hand_table();

/// What hand-drawn lines are drawn with.
struct HandPen {
    int samples_per_px = 1;    ///< pixels of the mask along a side of a pixel that the user sees
    double line_width_px = 2;  ///< as the user sees pixels
    std::uint64_t seed = 0;
};

/// The lines of a thinned mask drawn again by hand: edge response 255 where a stroke
/// covers a pixel's centre, else 0.
///
/// Each line between corners is one stroke. It is smoothed, runs beyond its ends by about
/// `overshoot_px`, wanders off by up to `jitter_px` in waves of about `wave_px`, and is
/// `line_width_px` wide, more or less by `width_spread`, thinner at its ends. `passes` strokes lie
/// over each other, each with its own waves. Lines shorter than `least_px` are left out.
///
/// The same seed gives the same image on every machine: the waves are value noise from hashes.
[[nodiscard]] core::Image<std::uint8_t> draw_by_hand(const core::Image<std::uint8_t>& thinned,
                                                     const HandParams& params,
                                                     const HandPen& pen);

}  // namespace ink::shade
