#pragma once

#include <string_view>

#include "harness/rows/row.h"
#include "harness/truths/tracing.h"
#include "score/drawing.h"
#include "score/score.h"

namespace ink::harness {

/// What is scored against another choice of what counts than the headline's: the strokes of a
/// method's image, which is one for all choices, or for the oracle those of that very truth.
[[nodiscard]] score::Strokes strokes_against(const score::ScoringTruth& choice,
                                             const score::Strokes& strokes,
                                             std::string_view method);

/// Writes into `row` what strokes score at 2 px with either choice of intersections, and the recall
/// of intersections: of all, of those above and of those below the crease angle, each by a matching
/// of its own. `at_2px` is their score against `truth.scoring`, and already in the row.
void fill_intersections(const score::Strokes& strokes,
                        const score::Score& at_2px,
                        const ViewTruth& truth,
                        const ViewLists& lists,
                        Row& row);

/// Scores strokes at 2 px and writes all that into `row`: metrics, counts, recalls. `lists` are
/// list_view() of the truth.
void fill_score_2px(const score::Strokes& strokes,
                    const ViewTruth& truth,
                    const ViewLists& lists,
                    Row& row);

}  // namespace ink::harness
