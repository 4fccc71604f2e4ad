#pragma once

#include <vector>

#include "harness/scores/evaluations.h"
#include "harness/truths/tracing.h"
#include "score/soft_score.h"

namespace ink::harness {

/// The ink of a view's truth, drawn so wide: of all curves, for what is near a line that does not
/// count is left out (score::prepare_ink), with the harness's band and tolerance.
[[nodiscard]] score::InkTruth true_ink(const ViewTruth& truth, double line_width_px);

/// What was drawn as shares of pixels: an image of strengths is all or nothing by its threshold, a
/// grey one counts as it is; the oracle draws the true ink.
[[nodiscard]] core::Image<float> drawn_ink(const Evaluation& evaluation,
                                           const score::InkTruth& truth);

/// Writes the soft score of every evaluation that did not fail into its row.
void score_grey_lines(const ViewTruth& truth,
                      double line_width_px,
                      std::vector<Evaluation>& evaluations);

}  // namespace ink::harness
