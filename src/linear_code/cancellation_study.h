#pragma once

#include <vector>

#include "harness/rows/side_tables.h"
#include "harness/scores/evaluations.h"
#include "harness/scores/miss_prediction.h"
#include "harness/truths/tracing.h"
#include "linear_code/cancellation.h"

namespace ink::linear_code {

/// The columns of cancellation.csv: cell, silent_deg, class, dihedral_low_deg, dihedral_high_deg,
/// then counts. A boundary's bin is two empty fields.
[[nodiscard]] const harness::SideTable<CancellationRow>& cancellation_table();

/// For each evaluation of `view` whose method declares a code: what the code must miss
/// (predicted_positives(), from truth geometry and weights alone), beside what its image missed.
/// Both sets are thinned, cut and matched alike. Evaluations that failed and those without a code
/// have no rows.
[[nodiscard]] std::vector<CancellationRow> study_cancellation(
    const harness::ViewTruth& truth,
    const scene::View& view,
    harness::MissPredictor& predictor,
    const std::vector<harness::Evaluation>& evaluations);

}  // namespace ink::linear_code
