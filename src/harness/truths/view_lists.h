#pragma once

#include <optional>
#include <vector>

#include "harness/truths/tracing.h"
#include "score/drawing.h"

namespace ink::harness {

/// The truths of a view as lists, at 2 px: made once for all images that are scored against them.
struct ViewLists {
    score::TruthLists scoring;
    std::optional<score::TruthLists> other = std::nullopt;         ///< as in ViewTruth
    std::optional<score::TruthLists> with_crowded = std::nullopt;  ///< as in ViewTruth
};

[[nodiscard]] ViewLists list_view(const ViewTruth& truth);

/// A truth as lists at each of kTolerances_px (harness/cells/cell.h).
[[nodiscard]] std::vector<score::TruthLists> list_tolerances(const score::ScoringTruth& truth);

}  // namespace ink::harness
