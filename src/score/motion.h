#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "edge/edge_image.h"
#include "score/pixel_list.h"
#include "score/score.h"
#include "score/soft_score.h"
#include "truth/curve.h"

namespace ink::score {

// How an outline behaves in time (section 7 of the design). The frames of a sequence are scored
// against each other, so they must be so close in time that what is drawn moves by less than the
// tolerance from one to the next. Everything here is a serial function of its arguments, and the
// same for a sequence that runs backwards.

/// One image of a sequence.
struct MotionFrame {
    PixelList drawn;    ///< every pixel of the thinned image
    PixelList counted;  ///< of them those that count: outside the band, not ignored
    PixelList truth;    ///< every true pixel, ignored ones left out
};

/// A thresholded and thinned image (score::Strokes::thinned) beside its truth.
///
/// `truth` is prepared without a band (a line that comes out of the band has not appeared);
/// band and tolerance are the options'. Throws core::Error for another size or options outside
/// their range.
[[nodiscard]] MotionFrame motion_frame(const edge::Mask& thinned,
                                       const ScoringTruth& truth,
                                       const ScoreOptions& options);

/// Drawn pixels that come or go between successive frames.
struct Flicker {
    std::int64_t appeared = 0;     ///< counted pixels without a drawn one in reach a frame before
    std::int64_t disappeared = 0;  ///< counted pixels without a drawn one in reach a frame later
    /// Pixels like those, but with a true pixel in reach that came or went likewise (it has no true
    /// one in reach in the other frame): not in the two counts above.
    std::int64_t excused = 0;
    std::int64_t n_counted = 0;  ///< counted pixels of both frames of each step

    Flicker& operator+=(const Flicker& other);
    /// (appeared + disappeared) / n_counted, 0..1; nothing if nothing is drawn or there is no step.
    [[nodiscard]] std::optional<double> share() const;
    [[nodiscard]] bool operator==(const Flicker&) const = default;
};

/// Flicker beyond the truth's own change, over all steps of a sequence; reach is the tolerance.
///
/// The truth itself has none, nor has an image that stands still, right or wrong, nor one whose
/// lines all move by no more than the tolerance. An image drawn anew by chance in every frame has
/// nearly 1, unless it is dense. A frame with nothing drawn between two full ones makes all of
/// both flicker. One frame or none: all counts 0.
[[nodiscard]] Flicker flicker(std::span<const MotionFrame> frames, double tolerance_px);

/// How the ink of grey frames changes, in pixels' areas.
struct InkChange {
    double true_px = 0;    ///< sum of |change of the true share| over pixels
    double beyond_px = 0;  ///< sum of |drawn change - true change|

    InkChange& operator+=(const InkChange& other);
    [[nodiscard]] bool operator==(const InkChange&) const = default;
};

/// The change of drawn shares from one frame to the next, each beside its truth, over the pixels
/// that count in both. The truth itself has nothing beyond its own; an image that stands still has
/// all of it.
[[nodiscard]] InkChange ink_change(const core::Image<float>& drawn_before,
                                   const InkTruth& before,
                                   const core::Image<float>& drawn_after,
                                   const InkTruth& after);

/// Something drawn where no line is, followed through time.
struct FalseLine {
    int first_frame = 0;
    int last_frame = 0;
    std::int64_t n_px = 0;  ///< over all its frames
    bool is_cut = false;    ///< there in the sequence's first or last frame: it may live longer

    [[nodiscard]] int life() const { return last_frame - first_frame + 1; }
    [[nodiscard]] bool operator==(const FalseLine&) const = default;
};

/// The false lines of a sequence, by first frame, then by their first pixel there.
///
/// False is a counted pixel without a true one in reach. Two false pixels are of one line if they
/// touch (8 neighbours) in one frame, or lie in reach of each other in successive frames, or are
/// joined by a chain of such pairs: lines that merge or part are one. Empty for no frames.
[[nodiscard]] std::vector<FalseLine> false_lines(std::span<const MotionFrame> frames,
                                                 double tolerance_px);

/// How many lines lived 1, 2, .. frames: entry i is a life of i + 1. As long as the longest life.
[[nodiscard]] std::vector<std::int64_t> life_counts(std::span<const FalseLine> lines);

/// What makes a line of one frame the same line in another: its class and its mesh edge, or, for an
/// intersection, its two triangles (lower first). What is not used is kNoEdge and kNoTriangle.
struct Feature {
    truth::LineClass line_class = truth::LineClass::none;
    std::uint32_t edge = truth::kNoEdge;
    std::uint32_t face0 = truth::kNoTriangle;
    std::uint32_t face1 = truth::kNoTriangle;

    [[nodiscard]] auto operator<=>(const Feature&) const = default;
};

/// A feature in one frame: how much of it is to be seen, and how much of that is drawn.
struct FeatureSight {
    Feature feature;
    double length_px = 0;   ///< visible and asked for
    double covered_px = 0;  ///< of that, with a drawn pixel in reach

    /// covered / length; 0 for no length.
    [[nodiscard]] double share() const { return length_px > 0 ? covered_px / length_px : 0; }
};

/// The features of a frame's curves, each once, ascending; those without any length left out.
///
/// Curves are looked at in pieces of at most half a pixel, each in the pixel that holds its middle.
/// It is asked for outside the band, where it is not ignored, and where the truth has a pixel in
/// reach: thinning takes some from where lines crowd, and what the truth itself does not draw is
/// not dropped by others. `thinned` and `truth` as motion_frame() takes them.
[[nodiscard]] std::vector<FeatureSight> see_features(std::span<const truth::Curve> curves,
                                                     const edge::Mask& thinned,
                                                     const ScoringTruth& truth,
                                                     const ScoreOptions& options);

/// When a feature is there, shown or dropped. Between the two shares it is neither: what covers
/// about half of a line does not pop at every frame.
struct PopRules {
    double min_length_px = 4;        ///< shorter ones are not there
    double shown_share = 2.0 / 3;    ///< at least so much is drawn: shown
    double dropped_share = 1.0 / 3;  ///< at most so much: dropped
    int min_frames = 3;              ///< of a run of frames in which it is there; shorter ones do
                                     ///< not count: nothing can pop in them
};

/// How often persistent features pop.
struct PopCount {
    std::int64_t pops = 0;   ///< shown, then dropped in one or more frames, then shown again
    std::int64_t runs = 0;   ///< runs of successive frames in which one feature is there
    std::int64_t steps = 0;  ///< from frame to frame in these runs

    PopCount& operator+=(const PopCount& other);
    [[nodiscard]] bool operator==(const PopCount&) const = default;
};

/// Counts the pops of a sequence, one see_features() per frame. A feature that is away for a frame
/// (hidden, out of the image, of another class) starts a new run. Nothing for no frames.
[[nodiscard]] PopCount count_pops(std::span<const std::vector<FeatureSight>> frames,
                                  const PopRules& rules = {});

}  // namespace ink::score
