#pragma once

#include <vector>

#include "edge/edge_image.h"
#include "score/drawing.h"
#include "score/score.h"

namespace ink::score {

/// A pixel of an image.
struct Pixel {
    int x_px = 0;
    int y_px = 0;

    friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// The pixels that are wrong whatever matching is found, row by row: as many as score() counts.
///
/// Of unmatched duplicates and unmatched truth only the numbers are unique, so they are not here:
/// an unmatched pixel with a partner in reach can take the place of the one that partner is matched
/// to, and the matching is as large as before. No single one of them can be called wrong.
struct WrongPixels {
    std::vector<Pixel>
        false_positives;  ///< predicted (thinned) pixels without a truth pixel in reach
    std::vector<Pixel> false_negatives;  ///< truth pixels without a predicted pixel in reach
    edge::Mask drawn;  ///< 1 where something was drawn, not yet thinned; band taken out
};

/// Which pixels score() calls false positives and false negatives.
///
/// Throws core::Error for another size or options outside their range. Empty images have none.
[[nodiscard]] WrongPixels wrong_pixels(const edge::EdgeImage& prediction,
                                       const ScoringTruth& truth,
                                       const ScoreOptions& options);

/// The same where truth and drawing are at hand as lists: `drawn` is what counts of the strokes,
/// with these options.
[[nodiscard]] WrongPixels wrong_pixels(const Strokes& strokes,
                                       const PixelList& drawn,
                                       const TruthLists& lists,
                                       const ScoreOptions& options);

/// The same of strokes that were made already with these options; `threshold` is not read.
[[nodiscard]] WrongPixels wrong_pixels(const Strokes& strokes,
                                       const ScoringTruth& truth,
                                       const ScoreOptions& options);

}  // namespace ink::score
