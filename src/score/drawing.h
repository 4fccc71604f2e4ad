#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "edge/edge_image.h"
#include "score/pixel_list.h"
#include "score/score.h"

namespace ink::score {

/// The stages of a comparison, one by one; score() runs them in the order in which they stand here.

/// A thresholded picture: all that is drawn, and the same made thin. Nothing is taken out yet.
struct Strokes {
    edge::Mask drawn;
    edge::Mask thinned;  ///< `drawn` again where the options say not to thin
    std::int64_t n_drawn = 0;
    std::int64_t n_thinned = 0;

    /// Drawn pixels over thinned pixels; 0 if none.
    [[nodiscard]] double mean_width_px() const {
        return n_thinned > 0 ? static_cast<double>(n_drawn) / static_cast<double>(n_thinned) : 0;
    }
};

/// Threshold and thin. Reads `thin` of the options; `threshold` is 1..255.
[[nodiscard]] Strokes make_strokes(const edge::EdgeImage& prediction,
                                   int threshold,
                                   const ScoreOptions& options);

/// The truth's side of a comparison, as lists.
struct TruthLists {
    PixelList truth;
    PixelList ignore;
    Disk disk;
};

/// Lists a truth's pixels, and those under its ignore map, for the options' tolerance.
[[nodiscard]] TruthLists list_truth(const ScoringTruth& truth, const ScoreOptions& options);

/// The same, if options and sizes will do. Throws core::Error as score() does if not.
[[nodiscard]] TruthLists checked_lists(const edge::EdgeImage& prediction,
                                       const ScoringTruth& truth,
                                       const ScoreOptions& options);

/// Takes band and ignore out of drawn pixels: of those left by the band, one with an ignored pixel
/// and no truth pixel within the tolerance is dropped. What is left counts.
[[nodiscard]] PixelList counted_pixels(edge::Mask drawn,
                                       const TruthLists& lists,
                                       const ScoreOptions& options);

/// The same of a mask with a bit a pixel.
[[nodiscard]] PixelList counted_pixels(const edge::BitMask& drawn,
                                       const TruthLists& lists,
                                       const ScoreOptions& options);

/// Matches what counts of a drawing with the truth.
[[nodiscard]] CurveCount match_counts(const PixelList& drawn, const TruthLists& lists);

/// What score() says of strokes that were made already with these options: several tolerances
/// need one thinning. `threshold` is not read.
///
/// Throws core::Error as score() does.
[[nodiscard]] Score score_strokes(const Strokes& strokes,
                                  const ScoringTruth& truth,
                                  const ScoreOptions& options);

/// The same of score_tolerance_sweep().
[[nodiscard]] std::vector<CurveCount> tolerance_sweep_of_strokes(
    const Strokes& strokes,
    const ScoringTruth& truth,
    const ScoreOptions& options,
    std::span<const double> tolerances_px);

/// Sets the pixels closer than `band_px` to the frame to 0.
void clear_band(core::Image<std::uint8_t>& image, int band_px);

/// Throws core::Error, which names both sizes, if the two pictures differ in size.
void check_same_size(const edge::EdgeImage& prediction, const core::Image<std::uint8_t>& truth);

}  // namespace ink::score
