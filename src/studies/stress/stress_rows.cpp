#include "studies/stress/stress_rows.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <new>
#include <optional>

#include "core/hash.h"
#include "core/parallel.h"
#include "core/simd.h"
#include "harness/evaluations.h"
#include "harness/intersection_scores.h"
#include "harness/tables/csv.h"
#include "harness/unscored_view.h"
#include "studies/stress/stress_counts.h"
#include "truth/limits.h"

namespace ink::studies {
namespace {

/// The truth of a case; without one, why.
struct StressTruth {
    std::optional<harness::ViewTruth> truth;
    std::string failure;
    std::int64_t non_finite = 0;
};

StressTruth trace(const StressCase& stress, const harness::TraceOptions& options) {
    StressTruth result;
    try {
        truth::SceneModel model(stress.scene_views.scene, options.truth);
        result.truth = harness::trace_view(model, stress.scene_views.views.front(), options);
        result.non_finite = count_non_finite(result.truth->traced);
        result.failure = harness::emptiness(*result.truth);
    } catch (const truth::TooLarge& reason) {
        result.failure = fmt::format("too_large: {}", reason.what());
    } catch (const std::bad_alloc&) {
        result.failure = "too_large: no memory to trace the truth";
    }
    return result;
}

/// Draws with one method, unscored; its image is empty if it failed.
harness::Evaluation draw_evaluation(const harness::MethodConfig& config,
                                    const scene::Scene& scene,
                                    const method::Frame& frame,
                                    std::int64_t& overflow) {
    std::vector<std::unique_ptr<harness::PreparedMethod>> methods;
    methods.push_back(std::make_unique<harness::PreparedMethod>(config, scene));
    const harness::MeasureOptions once{
        .threads = frame.threads, .min_repetitions = 0, .max_repetitions = 0, .skips = frame.skips};
    harness::Evaluation evaluation =
        std::move(harness::method_evaluations(methods, frame.view, once).front());
    evaluation.row.prepare_ns.reset();
    evaluation.row.pose_ns.reset();
    evaluation.row.cost.reset();
    const bool has_size = evaluation.image.width_px() == frame.view.width_px &&
                          evaluation.image.height_px() == frame.view.height_px;
    if (evaluation.row.is_ok() && !has_size) {
        evaluation.row.status = fmt::format("failed: an image of {} x {} px",
                                            evaluation.image.width_px(),
                                            evaluation.image.height_px());
    }
    if (evaluation.row.is_ok())
        overflow = count_overflow(methods.front()->method(), config, scene, frame);
    return evaluation;
}

void score_evaluation(const StressTruth& truth, harness::Evaluation& evaluation) {
    if (!evaluation.row.is_ok()) return;
    if (!truth.failure.empty()) evaluation.row.status = truth.failure;
    if (!evaluation.row.is_ok()) return;
    const score::Strokes strokes = score::make_strokes(
        evaluation.image, evaluation.threshold, harness::score_options(evaluation.threshold));
    harness::fill_score_2px(
        strokes, *truth.truth, harness::list_view(*truth.truth), evaluation.row);
    evaluation.row.image_hash = core::image_hash(evaluation.image);
    harness::fill_truth_facts(*truth.truth, evaluation.row);
}

}  // namespace

void StressCounts::add(const StressCounts& more) {
    non_finite += more.non_finite;
    overflow += more.overflow;
    lost += more.lost;
    differing += more.differing;
}

std::vector<StressRow> stress_rows(const StressCase& stress,
                                   const std::vector<harness::MethodConfig>& configs,
                                   const harness::MeasureOptions& measure,
                                   const harness::TraceOptions& options) {
    std::optional<core::ForcedSimdTarget> forced;
    for (const core::SimdTarget& target : core::simd_targets()) {
        if (target.name == stress.simd_target) forced.emplace(target);
    }
    const scene::Scene& scene = stress.drawn ? *stress.drawn : stress.scene_views.scene;
    const scene::View& view = stress.scene_views.views.front();
    const method::Frame frame{view, stress.threads.value_or(measure.threads), measure.skips};
    const StressTruth truth = trace(stress, options);
    const StressCounts given = count_inputs(scene, view);

    std::vector<harness::Evaluation> evaluations;
    if (truth.truth) evaluations = harness::baseline_evaluations(*truth.truth);
    const std::size_t baselines = evaluations.size();
    evaluations.resize(baselines + configs.size());
    std::vector<std::int64_t> overflow(evaluations.size(), 0);
    // Nothing is timed, so all may be drawn at once.
    core::parallel_for(evaluations.size(), core::hardware_threads(), [&](std::size_t i) {
        if (i >= baselines) {
            const harness::MethodConfig config = under_stress(configs[i - baselines], stress);
            evaluations[i] = draw_evaluation(config, scene, frame, overflow[i]);
        }
        score_evaluation(truth, evaluations[i]);
        evaluations[i].image = {};
    });

    const StressAxis& axis = find_stress_axis(stress.axis);
    std::vector<StressRow> rows;
    for (std::size_t i = 0; i < evaluations.size(); ++i) {
        harness::Row& row = evaluations[i].row;
        row.scene = stress.scene_views.scene.name;
        row.view = view.camera.name;
        row.split = scene::split_name(stress.scene_views.scene.split);
        row.width = view.width_px;
        row.height = view.height_px;
        row.threads = frame.threads;
        harness::fill_truth_settings(options, row);
        row.triangles = static_cast<std::int64_t>(scene::triangle_count(scene));
        StressCounts counts = given;
        counts.non_finite += truth.non_finite + count_non_finite(row);
        counts.overflow += overflow[i];
        // A difficulty takes no line out of the image: where all are gone the case is lost. Lines
        // that a zoom has made too dense to score are there.
        counts.lost = row.is_ok() || row.status.starts_with("crowded") ? 0 : 1;
        rows.push_back({stress.axis, stress.value, axis.unit, std::move(row), counts});
    }
    return rows;
}

void note_differences(std::vector<StressRow>& rows) {
    std::map<std::string, std::string> first;  // axis, scene and method to the image's hash
    for (StressRow& row : rows) {
        if (!row.row.is_ok() || !find_stress_axis(row.axis).same_images) continue;
        const std::string key =
            fmt::format("{},{},{}", row.axis, harness::csv_field(row.row.scene), row.row.method);
        const auto [known, is_new] = first.try_emplace(key, row.row.image_hash);
        row.counts.differing = known->second == row.row.image_hash ? 0 : 1;
    }
}

}  // namespace ink::studies
