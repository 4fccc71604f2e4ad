#include "harness/crowded.h"

#include <fmt/format.h>

#include "harness/cell.h"
#include "score/matching.h"

namespace ink::harness {

void fill_crowded(const score::Strokes& strokes,
                  const score::Score& at_2px,
                  const ViewTruth& truth,
                  Row& row) {
    row.with_crowded_2px = score::CurveCount{at_2px.k, at_2px.n_pred, at_2px.n_truth};
    if (!truth.with_crowded) return;
    const score::ScoreOptions options = score_options(1);  // the strokes have their threshold
    const score::TruthLists lists = score::list_truth(*truth.with_crowded, options);
    row.with_crowded_2px =
        score::match_counts(score::counted_pixels(strokes.thinned, lists, options), lists);
}

void note_crowded(const ViewTruth& truth, std::vector<Evaluation>& evaluations) {
    const double share = truth.traced.counts.crowded_share;
    if (share <= kMostCrowded) return;
    for (Evaluation& evaluation : evaluations) {
        if (!evaluation.row.is_ok()) continue;
        evaluation.row.status = fmt::format(
            "crowded: {:.0f} % of the true pixels are too dense to score, of {:.0f} % at most",
            100 * share,
            100 * kMostCrowded);
    }
}

}  // namespace ink::harness
