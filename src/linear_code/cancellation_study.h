#pragma once

#include <vector>

#include "harness/miss_prediction.h"
#include "harness/shots.h"
#include "harness/tracing.h"
#include "linear_code/cancellation.h"

namespace ink::linear_code {

/// For each shot of `view` whose method declares a code: what the code must miss (predicted_ink(),
/// from truth geometry and weights alone), beside what its picture missed. Both inks are thinned,
/// cut and matched alike. Shots that failed and those without a code have no rows.
[[nodiscard]] std::vector<CancellationRow> study_cancellation(
    const harness::ViewTruth& truth,
    const scene::View& view,
    harness::MissPredictor& predictor,
    const std::vector<harness::Shot>& shots);

}  // namespace ink::linear_code
