#include "linear_code/cancellation_study.h"

#include <glm/trigonometric.hpp>

#include "core/parallel.h"
#include "edge/thin.h"
#include "edge/threshold.h"
#include "harness/cell.h"
#include "linear_code/cancellation_ink.h"
#include "linear_code/cancellation_law.h"
#include "score/drawing.h"

namespace ink::linear_code {
namespace {

/// A shot with a code, the code worked out from the truth, and what came of both.
struct Study {
    const harness::Shot& shot;
    harness::Declaration declared;
    harness::TruthCode code;
    std::vector<CancellationRow> rows = {};
};

/// What all shots of a view are counted against.
struct CountedTruth {
    std::vector<score::Pixel> seeing;  ///< line_stencils()
    std::vector<KindPixels> kinds;
    score::TruthLists lists;
};

score::PixelList counted_ink(const edge::Mask& drawn,
                             const CountedTruth& counted,
                             const score::ScoreOptions& options) {
    return score::counted_pixels(edge::thin(drawn), counted.lists, options);
}

void fill_rows(const harness::ViewTruth& truth, const CountedTruth& counted, Study& study) {
    const harness::Shot& shot = study.shot;
    const score::ScoreOptions options = harness::score_options(shot.threshold);
    const score::PixelList predicted = counted_ink(
        predicted_ink(study.code, truth.traced.layers.triangle, counted.seeing, study.declared),
        counted,
        options);
    const score::PixelList measured =
        counted_ink(edge::threshold(shot.picture, shot.threshold), counted, options);
    const double silent_deg =
        glm::degrees(silent_bend_rad(*study.declared.code, study.declared.threshold));
    for (const auto& [kind, pixels] : counted.kinds) {
        study.rows.push_back(
            {.method = shot.row.method,
             .scene = shot.row.scene,
             .view = shot.row.view,
             .split = shot.row.split,
             .width_px = shot.row.width,
             .height_px = shot.row.height,
             .silent_deg = silent_deg,
             .kind = kind,
             .count = count_cancellation(pixels, predicted, measured, counted.lists.disk)});
    }
}

}  // namespace

std::vector<CancellationRow> study_cancellation(const harness::ViewTruth& truth,
                                                const scene::View& view,
                                                harness::MissPredictor& predictor,
                                                const std::vector<harness::Shot>& shots) {
    std::vector<Study> studies;
    studies.reserve(shots.size());
    for (const harness::Shot& shot : shots) {
        if (!shot.row.is_ok() || !shot.code) continue;
        studies.push_back({shot, {shot.code, shot.threshold}, predictor.code_of(*shot.code, view)});
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
