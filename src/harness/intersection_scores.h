#pragma once

#include "harness/row.h"
#include "harness/tracing.h"
#include "score/drawing.h"
#include "score/score.h"

namespace ink::harness {

/// Writes into `row` what strokes score at 2 px with either choice of intersections, and the recall
/// of intersections: of all, of those above and of those below the crease angle, each by a matching
/// of its own. `at_2px` is their score against `truth.scoring`, and already in the row.
void fill_intersections(const score::Strokes& strokes,
                        const score::Score& at_2px,
                        const ViewTruth& truth,
                        Row& row);

/// Scores strokes at 2 px and writes all that into `row`: metrics, counts, recalls.
void fill_score_2px(const score::Strokes& strokes, const ViewTruth& truth, Row& row);

}  // namespace ink::harness
