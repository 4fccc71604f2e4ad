#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edge/edge_image.h"
#include "harness/cells/cell.h"
#include "harness/rows/row.h"
#include "harness/scores/miss_prediction.h"
#include "harness/truths/compare_truths.h"
#include "harness/truths/tracing.h"
#include "score/soft_score.h"

namespace ink::harness {

/// One image of a view on its way to a row.
struct Evaluation {
    Row row;
    edge::EdgeImage image;
    int threshold = 128;
    bool is_grey = false;  ///< the image holds shares of pixels, not strengths
    std::optional<method::LinearCode> code;
    Scored scored;
};

/// The rows that stand in every run and are no methods: floor (`none`), one exact sample a pixel at
/// its centre (`sampled`) and at its corner (`exact_corner`), truth itself (`oracle`), in this
/// order.
[[nodiscard]] std::vector<Evaluation> baseline_evaluations(const ViewTruth& truth);

inline constexpr int kBaselines = 4;

/// Draws and times each method on `view`. One that fails is an evaluation whose row says so.
[[nodiscard]] std::vector<Evaluation> method_evaluations(const PreparedMethods& methods,
                                                         const scene::View& view,
                                                         const MeasureOptions& measure);

/// What the cross-check says of the truth stands in every row of the view; a truth that it
/// contradicts scores nobody.
void note_crosscheck(const harness::Crosscheck& check, std::vector<Evaluation>& evaluations);

/// Writes how the truth of a row is traced and which of it counts.
void fill_truth_settings(const TraceOptions& trace, Row& row);

/// Writes what all rows of one view have in common.
void fill_truth_facts(const ViewTruth& truth, Row& row);

/// Scores every evaluation that did not fail, beside a random image of as many pixels. Each view
/// has random images of its own: the rows must have scene, view and seed.
void score_evaluations(const ViewTruth& truth, std::vector<Evaluation>& evaluations);

/// Calls `score`, from several threads, for the evaluations that did not fail: of equal images at
/// equal thresholds for the first alone, and the others get what it has. Image hashes are filled.
void score_each(std::vector<Evaluation>& evaluations,
                const std::function<void(Evaluation&)>& score);

/// Writes the hash of its image into the row of every evaluation that did not fail.
void fill_image_hashes(std::vector<Evaluation>& evaluations);

/// Why each scored evaluation is wrong where it is.
void attribute_evaluations(const ViewTruth& truth,
                           const scene::View& view,
                           MissPredictor& predictor,
                           std::vector<Evaluation>& evaluations);

/// Adds a reason for each baseline that did not come out as it must: such a run says nothing about
/// methods either.
void check_baselines(const std::vector<Evaluation>& evaluations, std::vector<std::string>& reasons);

/// The ink of a view's truth, drawn so wide: of all curves, for what is near a line that does not
/// count is left out (score::prepare_ink), with the harness's band and tolerance.
[[nodiscard]] score::InkTruth true_ink(const ViewTruth& truth, double line_width_px);

/// What was drawn as shares of pixels: an image of strengths is all or nothing by its threshold, a
/// grey one counts as it is; the oracle draws the true ink.
[[nodiscard]] core::Image<float> drawn_ink(const Evaluation& evaluation,
                                           const score::InkTruth& truth);

/// Writes the soft score of every evaluation that did not fail into its row.
void score_grey_lines(const ViewTruth& truth,
                      double line_width_px,
                      std::vector<Evaluation>& evaluations);

}  // namespace ink::harness
