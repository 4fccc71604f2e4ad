#include "harness/shots.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/hash.h"
#include "core/parallel.h"
#include "harness/line_scores.h"
#include "score/chance.h"
#include "truth/curve_facts.h"

namespace ink::harness {
namespace {

edge::EdgeImage full_strength(const core::Image<std::uint8_t>& labels) {
    edge::EdgeImage picture(labels.width_px(), labels.height_px());
    std::transform(
        labels.data(), labels.data() + labels.size(), picture.data(), [](std::uint8_t label) {
            return label != 0 ? 255 : 0;
        });
    return picture;
}

/// Each view has random pictures of its own; the same of a seed, whatever else takes part.
std::uint64_t chance_seed(const Row& row) {
    return core::Hasher().value(row.seed).text(row.scene).text(row.view).result();
}

}  // namespace

std::vector<Shot> bracket_shots(const ViewTruth& truth) {
    std::vector<Shot> shots(3);
    const auto& labels = truth.scoring.labels;
    shots[0].row.method = "none";
    shots[0].picture = edge::EdgeImage(labels.width_px(), labels.height_px());
    shots[1].row.method = "sampled";
    shots[1].picture = truth.traced.sampled;
    shots[2].row.method = "oracle";
    shots[2].picture = full_strength(labels);
    return shots;
}

std::vector<Shot> method_shots(std::vector<std::unique_ptr<PreparedMethod>>& methods,
                               const scene::View& view,
                               const MeasureOptions& measure) {
    std::vector<edge::EdgeImage> pictures;
    std::vector<DrawTimes> times = draw_in_turns(methods, view, measure, pictures);
    std::vector<Shot> shots(methods.size());
    for (std::size_t i = 0; i < methods.size(); ++i) {
        shots[i].row = methods[i]->row();
        shots[i].picture = std::move(pictures[i]);
        shots[i].threshold = methods[i]->threshold();
        if (methods[i]->failure().empty()) shots[i].code = methods[i]->method().code();
        if (!times[i].failure.empty()) shots[i].row.status = times[i].failure;
        fill_skips(times[i], measure.skips, shots[i].row);
        fill_times(std::move(times[i].draw_ns), shots[i].row);
    }
    return shots;
}

void attribute_shots(const ViewTruth& truth,
                     const scene::View& view,
                     MissPredictor& predictor,
                     std::vector<Shot>& shots) {
    for (Shot& shot : shots) {
        if (!shot.row.is_ok()) continue;
        shot.scored.attribution =
            predictor.attribute(shot.scored.wrong_2px, truth, view, {shot.code, shot.threshold});
        shot.row.causes = shot.scored.attribution.counts;
    }
}

void fill_truth_facts(const ViewTruth& truth, Row& row) {
    const truth::ContourLengths behind = truth::contour_lengths(truth.traced.curves);
    row.contour_sky_px = behind.sky_px;
    row.contour_other_px = behind.other_object_px;
    row.contour_self_px = behind.self_px;
    row.truth_merged_px = static_cast<std::int64_t>(truth.traced.counts.merged_px);
    row.crowded_share = truth.traced.counts.crowded_share;
}

void score_shots(const ViewTruth& truth, std::vector<Shot>& shots) {
    const LineTruth lines = prepare_lines(truth);
    const score::Chance chance(truth.scoring, score_options(255), chance_seed(shots.front().row));
    // Scores are not timed, so they may use every core.
    core::parallel_for(shots.size(), core::hardware_threads(), [&](std::size_t i) {
        Shot& shot = shots[i];
        if (!shot.row.is_ok()) return;
        shot.scored = score_picture(shot.picture, truth.scoring, shot.threshold);
        fill_scores(shot.scored, shot.row);
        shot.row.chance = chance.counts(shot.row.n_pred);
        shot.row.lines = score_lines(shot.scored.strokes, lines);
        shot.scored.strokes = {};
        shot.row.image_hash = core::image_hash(shot.picture);
    });
    for (Shot& shot : shots)
        fill_truth_facts(truth, shot.row);
}

void note_witness(const harness::WitnessCheck& check, std::vector<Shot>& shots) {
    const double rate = check.agreement.disagreement_rate();
    const harness::ClassAgreement total = check.agreement.total();
    for (Shot& shot : shots) {
        shot.row.witness_disagreement = rate;
        shot.row.witness_px = total.truth_px + total.witness_px;
        if (shot.row.is_ok() && rate > harness::kAllowedShare) {
            shot.row.status = fmt::format(
                "truth_disputed: the witness disagrees on {:.3f} % of the lines", 100 * rate);
        }
    }
}

void check_brackets(const std::vector<Shot>& shots, std::vector<std::string>& reasons) {
    for (const Shot& shot : shots) {
        const Row& row = shot.row;
        if (!row.is_ok() || !row.f_2px) continue;
        if (row.method == "oracle" && *row.f_2px != 1) {
            reasons.push_back(fmt::format(
                "oracle has F = {:.6f} on {} {}, not 1", *row.f_2px, row.scene, row.view));
        }
        if (row.method == "none" && row.n_truth > 0 && *row.f_2px != 0) {
            reasons.push_back(fmt::format(
                "none has F = {:.6f} on {} {}, not 0", *row.f_2px, row.scene, row.view));
        }
    }
}

}  // namespace ink::harness
