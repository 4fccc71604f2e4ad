#include "harness/cells/view_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <new>
#include <utility>

#include "core/parallel.h"
#include "harness/scores/evaluations.h"
#include "harness/scores/intersection_scores.h"
#include "harness/truths/tracing.h"
#include "harness/truths/unscored_view.h"

namespace ink::harness {
namespace {

/// Writes into every row what does not depend on its score.
void prepare_rows(const scene::Scene& scene,
                  const scene::View& view,
                  const TracedView& traced,
                  const CellOptions& options,
                  std::vector<Evaluation>& evaluations) {
    for (Evaluation& evaluation : evaluations) {
        if (!traced.has_truth()) evaluation.row.status = traced.failure;
        fill_place(scene, view, options, evaluation.row);
        if (evaluation.row.cost) evaluation.row.cost->frame = traced.counts;
    }
    if (traced.check) note_crosscheck(*traced.check, evaluations);
    if (traced.has_truth()) note_empty(traced.truth, evaluations);
}

void add_baselines(const TracedView& traced, std::vector<Evaluation>& evaluations) {
    std::vector<Evaluation> baselines = baseline_evaluations(traced.truth);
    std::move(baselines.begin(), baselines.end(), std::back_inserter(evaluations));
}

/// Scores at 2 px alone.
void score_briefly(const ViewTruth& truth, std::vector<Evaluation>& evaluations) {
    const ViewLists lists = list_view(truth);
    score_each(evaluations, [&](Evaluation& evaluation) {
        const int threshold = evaluation.threshold;
        fill_score_2px(score::make_strokes(evaluation.image, threshold, score_options(threshold)),
                       truth,
                       lists,
                       evaluation.row);
    });
    for (Evaluation& evaluation : evaluations)
        fill_truth_facts(truth, evaluation.row);
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
    row.projection = scene::kProjectionNames[view.camera.is_parallel() ? 1 : 0];
    row.split = scene::split_name(scene.split);
    row.scene_kind = scene.kind;
    row.width = view.width_px;
    row.height = view.height_px;
    row.threads = options.measure.threads;
    row.seed = options.seed;
    fill_truth_settings(options.trace, row);
    row.triangles = static_cast<std::int64_t>(scene::triangle_count(scene));
}

std::vector<Evaluation> draw_view(const ViewDrawings& drawings, const MeasureOptions& measure) {
    std::vector<Evaluation> drawn(drawings.methods);
    const std::size_t parts = (drawings.methods + drawings.at_once - 1) / drawings.at_once;
    core::parallel_for(parts, drawings.lanes, [&](std::size_t part) {
        const std::size_t first = part * drawings.at_once;
        const std::shared_ptr<PreparedMethods> methods =
            drawings.ready(first, std::min(drawings.methods, first + drawings.at_once));
        std::vector<Evaluation> some = method_evaluations(*methods, drawings.view, measure);
        for (std::size_t i = 0; i < some.size(); ++i) {
            if (drawings.see) drawings.see(first + i, *methods->at(i), some[i]);
            drawn[first + i] = std::move(some[i]);
        }
    });
    return drawn;
}

void finish_evaluations(const scene::Scene& scene,
                        const scene::View& view,
                        const TracedView& traced,
                        const CellOptions& options,
                        std::vector<Evaluation>& evaluations) {
    if (options.scores == Scores::none) {
        for (Evaluation& evaluation : evaluations)
            fill_place(scene, view, options, evaluation.row);
        return fill_image_hashes(evaluations);
    }
    if (options.scores != Scores::settings) add_baselines(traced, evaluations);
    prepare_rows(scene, view, traced, options, evaluations);
    if (!traced.has_truth()) return;
    if (options.scores == Scores::full) {
        score_evaluations(traced.truth, evaluations);
    } else {
        score_briefly(traced.truth, evaluations);
    }
    if (options.line_width_px) score_grey_lines(traced.truth, *options.line_width_px, evaluations);
    if (options.scores_crowded && emptiness(traced.truth).empty()) return;
    note_crowded(traced.truth, evaluations);
}

}  // namespace ink::harness
