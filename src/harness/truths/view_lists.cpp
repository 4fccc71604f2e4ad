#include "harness/truths/view_lists.h"

#include "harness/cells/cell.h"

namespace ink::harness {
namespace {

score::TruthLists list_at(const score::ScoringTruth& truth, double tolerance_px) {
    score::ScoreOptions options = score_options(1);  // images have thresholds of their own
    options.tolerance_px = tolerance_px;
    return score::list_truth(truth, options);
}

}  // namespace

ViewLists list_view(const ViewTruth& truth) {
    ViewLists lists{list_at(truth.scoring, kTolerance_px)};
    if (truth.other) lists.other = list_at(*truth.other, kTolerance_px);
    if (truth.with_crowded) lists.with_crowded = list_at(*truth.with_crowded, kTolerance_px);
    return lists;
}

std::vector<score::TruthLists> list_tolerances(const score::ScoringTruth& truth) {
    std::vector<score::TruthLists> lists;
    for (const double tolerance_px : kTolerances_px)
        lists.push_back(list_at(truth, tolerance_px));
    return lists;
}

}  // namespace ink::harness
