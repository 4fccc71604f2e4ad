#pragma once

#include <string>
#include <vector>

#include "harness/evaluations.h"
#include "harness/tracing.h"

namespace ink::harness {

/// Why a view has no score, because no true pixel of it counts: "empty: ..."; "" if one does, or if
/// the view is too crowded to be scored (crowded.h).
[[nodiscard]] std::string emptiness(const ViewTruth& truth);

/// Gives the rows of such a view that status; rows that failed keep theirs.
void note_empty(const ViewTruth& truth, std::vector<Evaluation>& evaluations);

}  // namespace ink::harness
