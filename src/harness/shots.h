#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edge/edge_image.h"
#include "harness/cell.h"
#include "harness/miss_prediction.h"
#include "harness/row.h"
#include "harness/shown_view.h"
#include "harness/tracing.h"
#include "harness/witness_cache.h"

namespace ink::harness {

/// One picture of a view on its way to a row.
struct Shot {
    Row row;
    edge::EdgeImage picture;
    int threshold = 128;
    std::optional<method::LinearCode> code;
    Scored scored;
};

/// The rows that stand in every run and are no methods: floor (`none`), one-sample ceiling
/// (`sampled`), truth itself (`oracle`), in this order.
[[nodiscard]] std::vector<Shot> bracket_shots(const ViewTruth& truth);

/// Draws and times every method on `view`, in turns. A method that fails is a shot whose row says
/// so.
[[nodiscard]] std::vector<Shot> method_shots(std::vector<std::unique_ptr<PreparedMethod>>& methods,
                                             const scene::View& view,
                                             const MeasureOptions& measure);

/// What the witness says of the truth stands in every row of the view; a truth that it disputes
/// scores nobody.
void note_witness(const harness::WitnessCheck& check, std::vector<Shot>& shots);

/// Writes what all rows of one view have in common.
void fill_truth_facts(const ViewTruth& truth, Row& row);

/// Scores every shot that did not fail, beside a random picture of as many pixels. Each view has
/// random pictures of its own: the rows must have scene, view and seed.
void score_shots(const ViewTruth& truth, std::vector<Shot>& shots);

/// Why each scored shot is wrong where it is.
void attribute_shots(const ViewTruth& truth,
                     const scene::View& view,
                     MissPredictor& predictor,
                     std::vector<Shot>& shots);

/// Adds a reason for each bracket that did not come out as it must: such a run says nothing about
/// methods either.
void check_brackets(const std::vector<Shot>& shots, std::vector<std::string>& reasons);

}  // namespace ink::harness
