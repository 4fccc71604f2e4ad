#include "harness/scores/evaluations.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "core/hash.h"
#include "core/parallel.h"
#include "harness/scores/bins.h"
#include "harness/scores/intersection_scores.h"
#include "harness/truths/unscored_view.h"
#include "score/coverage.h"
#include "score/drawing.h"
#include "truth/curve_facts.h"

namespace ink::harness {
namespace {

edge::EdgeImage full_response(const core::Image<std::uint8_t>& labels) {
    return core::mapped<std::uint8_t>(labels, [](int label) { return label != 0 ? 255 : 0; });
}

/// For each evaluation the first that has the same image and threshold: many settings of a method
/// draw the same on most scenes, and so do methods that differ elsewhere. Those that failed stand
/// for themselves, and so does the oracle, which is scored otherwise.
std::vector<std::size_t> first_equals(const std::vector<Evaluation>& evaluations) {
    std::map<std::pair<std::string, int>, std::vector<std::size_t>> known;
    std::vector<std::size_t> firsts(evaluations.size());
    for (std::size_t i = 0; i < evaluations.size(); ++i) {
        const Evaluation& evaluation = evaluations[i];
        firsts[i] = i;
        if (!evaluation.row.is_ok() || evaluation.row.method == kOracle) continue;
        auto& alike = known[{evaluation.row.image_hash, evaluation.threshold}];
        const auto found = std::ranges::find_if(
            alike, [&](std::size_t first) { return evaluations[first].image == evaluation.image; });
        if (found == alike.end()) {
            alike.push_back(i);
        } else {
            firsts[i] = *found;
        }
    }
    return firsts;
}

/// Each view has random images of its own; the same of a seed, whatever else takes part.
std::uint64_t random_seed(const Row& row) {
    return core::Hasher().value(row.seed).text(row.scene).text(row.view).result();
}

}  // namespace

std::vector<Evaluation> baseline_evaluations(const ViewTruth& truth) {
    std::vector<Evaluation> evaluations;
    const auto add = [&](std::string_view name, edge::EdgeImage image) {
        Evaluation& added = evaluations.emplace_back();
        added.row.method = name;
        added.image = std::move(image);
    };
    const auto& labels = truth.scoring.labels;
    add("none", edge::EdgeImage(labels.width_px(), labels.height_px()));
    add("sampled", truth.traced.sampled);
    add("exact_corner", truth.traced.exact_corner);
    add(kOracle, full_response(labels));
    return evaluations;
}

std::vector<Evaluation> method_evaluations(const PreparedMethods& methods,
                                           const scene::View& view,
                                           const MeasureOptions& measure) {
    std::vector<edge::EdgeImage> images;
    std::vector<DrawTimes> times = draw_in_turns(methods, view, measure, images);
    std::vector<Evaluation> evaluations(methods.size());
    for (std::size_t i = 0; i < methods.size(); ++i) {
        PreparedMethod& method = *methods[i];
        evaluations[i].row = method.row();
        evaluations[i].image = std::move(images[i]);
        evaluations[i].threshold = method.threshold();
        evaluations[i].is_grey = method.config().is_grey || method.config().is_outside;
        if (method.failure().empty()) evaluations[i].code = method.method().code();
        if (!times[i].failure.empty()) evaluations[i].row.status = times[i].failure;
        fill_skips(times[i], measure.skips, evaluations[i].row);
        fill_times(times[i], evaluations[i].row);
    }
    return evaluations;
}

void attribute_evaluations(const ViewTruth& truth,
                           const scene::View& view,
                           MissPredictor& predictor,
                           std::vector<Evaluation>& evaluations) {
    for (Evaluation& evaluation : evaluations) {
        if (!evaluation.row.is_ok()) continue;
        evaluation.scored.attribution = predictor.attribute(
            evaluation.scored.wrong_2px, truth, view, {evaluation.code, evaluation.threshold});
        evaluation.row.causes = evaluation.scored.attribution.counts;
    }
}

void fill_truth_settings(const TraceOptions& trace, Row& row) {
    row.crease_deg = trace.crease_deg();
    row.creases = trace.truth.creases;
    row.weld_epsilon = trace.truth.weld_epsilon;
    row.intersections = trace.intersections;
}

void fill_truth_facts(const ViewTruth& truth, Row& row) {
    const truth::ContourLengths behind = truth::contour_lengths(truth.traced.curves);
    row.contour_sky_px = behind.sky_px;
    row.contour_other_px = behind.other_object_px;
    row.contour_self_px = behind.self_px;
    row.truth_merged_px = static_cast<std::int64_t>(truth.traced.counts.merged_px);
    row.crowded_share = truth.traced.counts.crowded_share;
    row.rounding_px = truth.traced.counts.rounding_px;
}

void score_evaluations(const ViewTruth& truth, std::vector<Evaluation>& evaluations) {
    const std::vector<TruthBin> bins = bin_truth(truth.traced, truth.scoring);
    const ViewLists lists = list_view(truth);
    const std::vector<score::TruthLists> tolerances = list_tolerances(truth.scoring);
    const score::RandomBaseline random_baseline(
        truth.scoring, score_options(255), random_seed(evaluations.front().row));
    score_each(evaluations, [&](Evaluation& evaluation) {
        Scored& scored = evaluation.scored;
        scored = score_image(evaluation.image, tolerances, evaluation.threshold);
        fill_scores(scored, evaluation.row);
        fill_intersections(scored.strokes, scored.at_2px, truth, lists, evaluation.row);
        fill_crowded(scored.strokes, scored.at_2px, truth, lists, evaluation.row);
        evaluation.row.random_baseline = random_baseline.counts(evaluation.row.n_pred);
        score::DrawnMatcher matcher(scored.drawn, lists.scoring.disk);
        evaluation.row.bins = match_bins(matcher, bins);
        scored.strokes = {};
        scored.drawn = {};
    });
    for (Evaluation& evaluation : evaluations)
        fill_truth_facts(truth, evaluation.row);
}

void score_each(std::vector<Evaluation>& evaluations,
                const std::function<void(Evaluation&)>& score) {
    fill_image_hashes(evaluations);
    const std::vector<std::size_t> firsts = first_equals(evaluations);
    // Scores are not timed, so they may use every core.
    core::parallel_for(evaluations.size(), core::hardware_threads(), [&](std::size_t i) {
        if (firsts[i] == i && evaluations[i].row.is_ok()) score(evaluations[i]);
    });
    for (std::size_t i = 0; i < evaluations.size(); ++i) {
        if (firsts[i] == i) continue;
        evaluations[i].scored = evaluations[firsts[i]].scored;
        copy_scores(evaluations[firsts[i]].row, evaluations[i].row);
    }
}

void fill_image_hashes(std::vector<Evaluation>& evaluations) {
    core::parallel_for(evaluations.size(), core::hardware_threads(), [&](std::size_t i) {
        Evaluation& evaluation = evaluations[i];
        if (evaluation.row.is_ok()) evaluation.row.image_hash = core::image_hash(evaluation.image);
    });
}

void note_crosscheck(const harness::Crosscheck& check, std::vector<Evaluation>& evaluations) {
    const double rate = check.agreement.disagreement_rate();
    const harness::ClassAgreement total = check.agreement.total();
    std::map<std::string, double> coincident_px;
    for (std::size_t c = 0; c < truth::kLineClasses.size(); ++c) {
        const double length_px = check.agreement.by_class[c].coincident_px;
        if (length_px > 0)
            coincident_px[std::string(truth::name(truth::kLineClasses[c]))] = length_px;
    }
    for (Evaluation& evaluation : evaluations) {
        evaluation.row.coincident_px_by_class = coincident_px;
        evaluation.row.reference_disagreement = rate;
        evaluation.row.crosscheck_px = total.truth_px + total.crosscheck_px;
        evaluation.row.crosscheck_abstained = check.agreement.abstained_share();
        if (evaluation.row.is_ok() && rate > harness::kAllowedShare) {
            evaluation.row.status = fmt::format(
                "reference_disagreement: the cross-check disagrees on {:.3f} % of the lines",
                100 * rate);
        }
    }
}

void check_baselines(const std::vector<Evaluation>& evaluations,
                     std::vector<std::string>& reasons) {
    for (const Evaluation& evaluation : evaluations) {
        const Row& row = evaluation.row;
        if (row.method != kOracle && row.method != "none") continue;
        const double wanted = row.method == kOracle ? 1 : 0;
        const auto expect = [&](std::optional<double> f, const char* what) {
            if (!f || *f == wanted) return;
            reasons.push_back(fmt::format("{} has F = {:.6f} on {} {}{}, not {}",
                                          row.method,
                                          *f,
                                          row.scene,
                                          row.view,
                                          what,
                                          wanted));
        };
        const auto f_of = [](const std::optional<score::CurveCount>& counts) {
            return counts ? std::optional(counts->f()) : std::nullopt;
        };
        expect(f_of(row.with_crowded_2px), " with crowded pixels");
        if (!row.is_ok()) continue;
        expect(row.f_2px, "");
        expect(row.f_1px, " within 1 px");
        expect(row.soft ? row.soft->f() : std::nullopt, " of ink");
        expect(f_of(row.above_crease_2px), " without flat intersections");
        expect(f_of(row.all_intersections_2px), " with all intersections");
    }
}

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
