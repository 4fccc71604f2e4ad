#include "linear_code/cancellation_study.h"

#include <glm/trigonometric.hpp>
#include <utility>

#include "core/parallel.h"
#include "edge/thin.h"
#include "edge/threshold.h"
#include "harness/cell.h"
#include "linear_code/cancellation_law.h"
#include "linear_code/predicted_positives.h"
#include "score/drawing.h"

namespace ink::linear_code {
namespace {

/// An evaluation with a code, the code worked out from the truth, and what came of both.
struct Study {
    const harness::Evaluation& evaluation;
    harness::Declaration declared;
    harness::TruthCode code;
    std::vector<CancellationRow> rows = {};
};

/// What all evaluations of a view are counted against.
struct CountedTruth {
    std::vector<score::Pixel> seeing;  ///< line_stencils()
    std::vector<KindPixels> kinds;
    score::TruthLists lists;
};

score::PixelList counted_positives(const edge::Mask& drawn, const CountedTruth& counted) {
    edge::BitMask thinned(drawn);
    edge::thin(thinned);
    return score::counted_pixels(std::move(thinned), counted.lists);
}

void fill_rows(const harness::ViewTruth& truth, const CountedTruth& counted, Study& study) {
    const harness::Evaluation& evaluation = study.evaluation;
    const auto ink_of = [&](const edge::Mask& drawn) {
        return CountedInk(counted_positives(drawn, counted), counted.lists.disk, drawn.width_px());
    };
    CountedInk predicted = ink_of(predicted_positives(
        study.code, truth.traced.layers.triangle, counted.seeing, study.declared));
    CountedInk measured = ink_of(edge::threshold(evaluation.image, evaluation.threshold));
    const double silent_deg =
        glm::degrees(silent_deviation_rad(*study.declared.code, study.declared.threshold));
    for (const auto& [kind, pixels] : counted.kinds) {
        study.rows.push_back({.method = evaluation.row.method,
                              .scene = evaluation.row.scene,
                              .view = evaluation.row.view,
                              .split = evaluation.row.split,
                              .width_px = evaluation.row.width,
                              .height_px = evaluation.row.height,
                              .silent_deg = silent_deg,
                              .kind = kind,
                              .count = count_cancellation(pixels, predicted, measured)});
    }
}

}  // namespace

std::vector<CancellationRow> study_cancellation(
    const harness::ViewTruth& truth,
    const scene::View& view,
    harness::MissPredictor& predictor,
    const std::vector<harness::Evaluation>& evaluations) {
    std::vector<Study> studies;
    studies.reserve(evaluations.size());
    for (const harness::Evaluation& evaluation : evaluations) {
        if (!evaluation.row.is_ok() || !evaluation.code) continue;
        studies.push_back({evaluation,
                           {evaluation.code, evaluation.threshold},
                           predictor.code_of(*evaluation.code, view)});
    }
    if (studies.empty()) return {};
    const CountedTruth counted{line_stencils(harness::stencils_of(truth)),
                               sort_by_kind(truth.traced, truth.scoring),
                               score::list_truth(truth.scoring, harness::score_options(255))};
    core::parallel_for(studies.size(), core::hardware_threads(), [&](std::size_t i) {
        fill_rows(truth, counted, studies[i]);
    });
    std::vector<CancellationRow> rows;
    for (Study& study : studies)
        rows.insert(rows.end(), study.rows.begin(), study.rows.end());
    return rows;
}

}  // namespace ink::linear_code
