#include "harness/crowded.h"

#include <fmt/format.h>

#include "harness/intersection_scores.h"

namespace ink::harness {

void fill_crowded(const score::Strokes& strokes,
                  const score::Score& at_2px,
                  const ViewTruth& truth,
                  const ViewLists& lists,
                  Row& row) {
    row.with_crowded_2px = score::CurveCount{at_2px.k, at_2px.n_pred, at_2px.n_truth};
    if (!lists.with_crowded) return;
    const score::Strokes all = strokes_against(*truth.with_crowded, strokes, row.method);
    row.with_crowded_2px = score::match_counts(
        score::counted_pixels(all.thinned, *lists.with_crowded), *lists.with_crowded);
}

void note_crowded(const ViewTruth& truth, std::vector<Evaluation>& evaluations) {
    const double share = truth.traced.counts.crowded_share;
    if (share <= kMostCrowded) return;
    for (Evaluation& evaluation : evaluations) {
        if (!evaluation.row.is_ok()) continue;
        clear_scores(evaluation.row);
        evaluation.row.status = fmt::format(
            "crowded: {:.0f} % of the true pixels are too dense to score, of {:.0f} % at most",
            100 * share,
            100 * kMostCrowded);
    }
}

}  // namespace ink::harness
