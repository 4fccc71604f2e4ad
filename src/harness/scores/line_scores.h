#pragma once

#include <vector>

#include "harness/scores/bins.h"
#include "harness/truths/tracing.h"
#include "score/cracks.h"
#include "score/drawing.h"
#include "score/far_positives.h"
#include "score/line_width.h"
#include "score/offset.h"

namespace ink::harness {

/// What the headline F does not say of an image, because it thins and forgives two pixels.
struct LineScores {
    score::CrackScore cracks;
    score::Offsets offsets;
    score::Widths widths;
    score::PositiveCount positives;  ///< at 2 px
    std::vector<BinCount> bins;      ///< at 2 px
};

/// A view's truth made ready for that, from its sub-pixel curves; once a view.
struct LineTruth {
    score::Disk disk;
    int width_px = 0;
    score::CrackTruth cracks;
    score::NearestCurves nearest;
    std::vector<score::WidthProbe> probes;
    score::PositiveTruth positives;
    std::vector<TruthBin> bins;
};

[[nodiscard]] LineTruth prepare_lines(const ViewTruth& truth);

/// Scores a thresholded image with the harness's band and tolerance; `counted` is what of it counts
/// (score::counted_pixels). Only reads `truth`, so several threads may score against one.
[[nodiscard]] LineScores score_lines(const score::Strokes& strokes,
                                     const score::PixelList& counted,
                                     const LineTruth& truth);

}  // namespace ink::harness
