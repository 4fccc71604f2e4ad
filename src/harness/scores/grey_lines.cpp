#include "harness/scores/grey_lines.h"

#include "core/parallel.h"
#include "score/coverage.h"

namespace ink::harness {
score::InkTruth true_ink(const ViewTruth& truth, double line_width_px) {
    const auto& labels = truth.traced.labels;
    return score::prepare_ink(
        score::draw_coverage(
            truth.traced.curves, labels.width_px(), labels.height_px(), line_width_px),
        line_width_px,
        truth.scoring,
        score_options(1));
}

core::Image<float> drawn_ink(const Evaluation& evaluation, const score::InkTruth& truth) {
    if (evaluation.row.method == kOracle) return truth.coverage;
    return evaluation.is_grey ? score::ink_of(evaluation.image)
                              : score::ink_of(evaluation.image, evaluation.threshold);
}

void score_grey_lines(const ViewTruth& truth,
                      double line_width_px,
                      std::vector<Evaluation>& evaluations) {
    const score::InkTruth ink = true_ink(truth, line_width_px);
    // Scores are not timed, so they may use every core.
    core::parallel_for(evaluations.size(), core::hardware_threads(), [&](std::size_t i) {
        Evaluation& evaluation = evaluations[i];
        if (!evaluation.row.is_ok()) return;
        evaluation.row.soft = score::score_ink(drawn_ink(evaluation, ink), ink, score_options(1));
    });
}

}  // namespace ink::harness
