#include "harness/view_cells.h"

#include <fmt/format.h>

#include <iterator>
#include <new>

#include "core/hash.h"
#include "core/parallel.h"
#include "harness/crowded.h"
#include "harness/intersection_scores.h"

namespace ink::harness {
namespace {

/// Adds baselines, and writes into every row what does not depend on its score.
void prepare_rows(const scene::Scene& scene,
                  const scene::View& view,
                  const TracedView& traced,
                  const CellOptions& options,
                  std::vector<Evaluation>& evaluations) {
    std::vector<Evaluation> baselines = baseline_evaluations(traced.truth);
    std::move(baselines.begin(), baselines.end(), std::back_inserter(evaluations));
    for (Evaluation& evaluation : evaluations) {
        if (!traced.has_truth()) evaluation.row.status = traced.failure;
        fill_place(scene, view, options, evaluation.row);
        if (evaluation.row.cost) evaluation.row.cost->frame = traced.counts;
    }
    if (traced.check) note_crosscheck(*traced.check, evaluations);
}

}  // namespace

TracedView trace_with_facts(truth::SceneModel& model,
                            const scene::Scene& scene,
                            const scene::View& view,
                            const TraceOptions& trace) {
    TracedView traced;
    traced.counts = count_frame(scene, view);
    try {
        traced.truth = trace_view(model, view, trace);
        if (trace.crosscheck) {
            traced.check =
                harness::cached_crosscheck(model, view, traced.truth.traced, trace.cache);
        }
    } catch (const truth::TooLarge& reason) {
        traced.failure = fmt::format("too_large: {}", reason.what());
    } catch (const std::bad_alloc&) {
        traced.failure = "too_large: no memory to trace the truth";
    }
    return traced;
}

void fill_place(const scene::Scene& scene,
                const scene::View& view,
                const CellOptions& options,
                Row& row) {
    row.scene = scene.name;
    row.view = view.camera.name;
    row.split = scene::split_name(scene.split);
    row.width = view.width_px;
    row.height = view.height_px;
    row.threads = options.measure.threads;
    row.seed = options.seed;
    fill_truth_settings(options.trace, row);
    row.triangles = static_cast<std::int64_t>(scene::triangle_count(scene));
}

void finish_evaluations(const scene::Scene& scene,
                        const scene::View& view,
                        const TracedView& traced,
                        const CellOptions& options,
                        std::vector<Evaluation>& evaluations) {
    prepare_rows(scene, view, traced, options, evaluations);
    if (!traced.has_truth()) return;
    score_evaluations(traced.truth, evaluations);
    note_crowded(traced.truth, evaluations);
}

void finish_briefly(const scene::Scene& scene,
                    const scene::View& view,
                    const TracedView& traced,
                    const CellOptions& options,
                    std::vector<Evaluation>& evaluations) {
    prepare_rows(scene, view, traced, options, evaluations);
    if (!traced.has_truth()) return;
    // Scores are not timed, so they may use every core.
    core::parallel_for(evaluations.size(), core::hardware_threads(), [&](std::size_t i) {
        Evaluation& evaluation = evaluations[i];
        if (!evaluation.row.is_ok()) return;
        const score::ScoreOptions at_2px = score_options(evaluation.threshold);
        fill_score_2px(score::make_strokes(evaluation.image, evaluation.threshold, at_2px),
                       traced.truth,
                       evaluation.row);
        evaluation.row.image_hash = core::image_hash(evaluation.image);
    });
    for (Evaluation& evaluation : evaluations)
        fill_truth_facts(traced.truth, evaluation.row);
    note_crowded(traced.truth, evaluations);
}

}  // namespace ink::harness
