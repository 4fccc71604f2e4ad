#pragma once

#include <vector>

#include "edge/edge_image.h"
#include "lab/bins.h"
#include "lab/tracing.h"
#include "score/cracks.h"
#include "score/drawing.h"
#include "score/false_ink.h"
#include "score/line_width.h"
#include "score/offset.h"

namespace ink::lab {

/// What the headline F does not say of a picture, because it thins and forgives two pixels.
struct LineScores {
    score::CrackScore cracks;
    score::Offsets offsets;
    score::Widths widths;
    score::InkCount ink;  ///< at 2 px
};

/// A view's truth made ready for that, from its sub-pixel curves; once a view.
struct LineTruth {
    score::TruthLists lists;
    score::CrackTruth cracks;
    score::NearestCurves nearest;
    std::vector<score::WidthProbe> probes;
    score::InkTruth ink;
    std::vector<TruthBin> bins;
};

[[nodiscard]] LineTruth prepare_lines(const ViewTruth& truth);

/// What one picture scores against the lines.
struct LineResult {
    LineScores scores;
    std::vector<BinCount> bins;  ///< at 2 px
};

/// Scores `picture` at `threshold`, with the harness's band and tolerance. Made once a view and
/// shared: only reads `truth`, so several threads may score against one.
[[nodiscard]] LineResult score_lines(const edge::EdgeImage& picture,
                                     const LineTruth& truth,
                                     int threshold);

}  // namespace ink::lab
