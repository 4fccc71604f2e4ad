#pragma once

#include <string>
#include <vector>

#include "harness/scores/evaluations.h"
#include "harness/truths/tracing.h"

namespace ink::harness {

/// A view of which a larger share of the truth is crowded (truth/label_image.h) is not scored: what
/// is left of it says little of the view.
inline constexpr double kMostCrowded = 0.2;

/// Writes into `row` what strokes score at 2 px if crowded pixels count too. Where there are none,
/// that is `at_2px`.
void fill_crowded(const score::Strokes& strokes,
                  const score::Score& at_2px,
                  const ViewTruth& truth,
                  const ViewLists& lists,
                  Row& row);

/// The status of a view of which no true pixel counts, "empty: ...", or that of a crowded one if
/// that is why; "" if one counts.
[[nodiscard]] std::string emptiness(const ViewTruth& truth);

/// The truth of a view of `scene` that must have a score. Throws core::Error (where = scene and
/// view) where it is too large to trace, or no true pixel counts.
[[nodiscard]] ViewTruth trace_scored_view(truth::SceneModel& model,
                                          const std::string& scene,
                                          const scene::View& view,
                                          const TraceOptions& trace);

/// Gives the rows of an empty view that status, before they are scored; rows that failed keep
/// theirs.
void note_empty(const ViewTruth& truth, std::vector<Evaluation>& evaluations);

/// Gives the scored rows of a view that is too crowded the status "crowded: ..."; rows that failed
/// keep theirs.
void note_crowded(const ViewTruth& truth, std::vector<Evaluation>& evaluations);

}  // namespace ink::harness
