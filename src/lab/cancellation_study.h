#pragma once

#include <vector>

#include "lab/cancellation.h"
#include "lab/miss_prediction.h"
#include "lab/shots.h"
#include "lab/tracing.h"

namespace ink::lab {

/// For each shot of `view` whose method declares a code: what the code must miss (predicted_ink(),
/// from truth geometry and weights alone), beside what its picture missed. Both inks are thinned,
/// cut and matched alike. Shots that failed and those without a code have no rows.
[[nodiscard]] std::vector<CancellationRow> study_cancellation(const ViewTruth& truth,
                                                              const scene::View& view,
                                                              MissPredictor& predictor,
                                                              const std::vector<Shot>& shots);

}  // namespace ink::lab
