#pragma once

#include <optional>

#include "core/image.h"
#include "edge/edge_image.h"
#include "score/score.h"

namespace ink::score {

/// The ink of the true lines of a view, ready to be compared with drawings: made once a view.
struct InkTruth {
    core::Image<float> coverage;  ///< 0..1 a pixel (draw_coverage); 0 where nothing counts
    edge::Mask counts;            ///< 1 where ink counts
    double line_width_px = 0;     ///< of the lines
};

/// Takes out of the coverage, and of what counts, the band and all pixels from which an ignored one
/// is at most the tolerance away, or half a line and a pixel if that is more: the ink of an ignored
/// line is neither required nor penalised. A pixel that is left out has no ink, whatever is drawn.
/// Reads tolerance and band of the options; `truth` is of the coverage's image.
[[nodiscard]] InkTruth prepare_ink(core::Image<float> coverage,
                                   double line_width_px,
                                   const ScoringTruth& truth,
                                   const ScoreOptions& options);

/// How the ink of a drawing compares with that of the truth, in pixels' areas. Of a pixel with the
/// drawn share I and the true share C, min(I, C) is matched. What is left drawn there (I - C) moves
/// to what is left true (C - I) in pixels within the tolerance, the nearest first: it is misplaced.
///
/// drawn ink = matched + misplaced + surplus, true ink = matched + misplaced + missing. In reach of
/// surplus nothing is missing.
struct SoftScore {
    double line_width_px = 0;  ///< of the truth
    double matched_px = 0;     ///< where it belongs
    double misplaced_px = 0;   ///< drawn beside where it belongs, within the tolerance
    double missing_px = 0;     ///< true, and none is drawn in reach that is not needed elsewhere
    double surplus_px = 0;     ///< drawn, and none is true in reach that is not drawn already

    [[nodiscard]] double drawn_px() const { return matched_px + misplaced_px + surplus_px; }
    [[nodiscard]] double true_px() const { return matched_px + misplaced_px + missing_px; }
    /// Ink of another image beside it, of lines as wide.
    SoftScore& operator+=(const SoftScore& other);
    /// Soft F = 2 sum min(I, C) / sum (I + C); nothing if there is no true ink.
    [[nodiscard]] std::optional<double> f() const;
    /// Matched, drawn and true ink in whole 2^-24 px^2, whose sums are exact; F of it is soft F.
    [[nodiscard]] CurveCount counts() const;
};

/// Compares `drawn`, shares of pixels 0..1, with the truth. Reads tolerance of the options. Throws
/// core::Error for another size than the truth's, which names both.
[[nodiscard]] SoftScore score_ink(const core::Image<float>& drawn,
                                  const InkTruth& truth,
                                  const ScoreOptions& options);

/// Grey edge responses as shares of pixels: 255 covers all of one.
[[nodiscard]] core::Image<float> ink_of(const edge::EdgeImage& grey);

/// Edge responses of another kind as shares: all of a pixel at `threshold` and above, else nothing.
[[nodiscard]] core::Image<float> ink_of(const edge::EdgeImage& edge_responses, int threshold);

}  // namespace ink::score
