#include "harness/view_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <new>
#include <utility>

#include "core/parallel.h"
#include "harness/grey_lines.h"
#include "harness/intersection_scores.h"
#include "harness/unscored_view.h"
#include "harness/view_lists.h"

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

/// For each evaluation the first that has the same image and threshold: many settings of a method
/// draw the same on most scenes. Those that failed stand for themselves, and so does the oracle,
/// which is scored otherwise.
std::vector<std::size_t> first_equals(const std::vector<Evaluation>& evaluations) {
    std::map<std::pair<std::string, int>, std::vector<std::size_t>> known;
    std::vector<std::size_t> firsts(evaluations.size());
    for (std::size_t i = 0; i < evaluations.size(); ++i) {
        const Evaluation& evaluation = evaluations[i];
        firsts[i] = i;
        if (!evaluation.row.is_ok() || evaluation.row.method == kOracle) continue;
        auto& alike = known[{evaluation.row.image_hash, evaluation.threshold}];
        const auto found = std::find_if(alike.begin(), alike.end(), [&](std::size_t first) {
            return evaluations[first].image == evaluation.image;
        });
        if (found == alike.end()) {
            alike.push_back(i);
        } else {
            firsts[i] = *found;
        }
    }
    return firsts;
}

/// Scores at 2 px alone; equal images at equal thresholds once.
void score_briefly(const ViewTruth& truth, std::vector<Evaluation>& evaluations) {
    fill_image_hashes(evaluations);
    const ViewLists lists = list_view(truth);
    const std::vector<std::size_t> firsts = first_equals(evaluations);
    // Scores are not timed, so they may use every core.
    core::parallel_for(evaluations.size(), core::hardware_threads(), [&](std::size_t i) {
        if (firsts[i] != i || !evaluations[i].row.is_ok()) return;
        const int threshold = evaluations[i].threshold;
        fill_score_2px(
            score::make_strokes(evaluations[i].image, threshold, score_options(threshold)),
            truth,
            lists,
            evaluations[i].row);
    });
    for (std::size_t i = 0; i < evaluations.size(); ++i) {
        if (firsts[i] != i) copy_score_2px(evaluations[firsts[i]].row, evaluations[i].row);
        fill_truth_facts(truth, evaluations[i].row);
    }
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
    const std::size_t turns_each = drawings.skips.size();
    std::vector<Evaluation> drawn(drawings.methods * turns_each);
    const std::size_t parts = (drawings.methods + drawings.at_once - 1) / drawings.at_once;
    core::parallel_for(parts, drawings.lanes, [&](std::size_t part) {
        const std::size_t first = part * drawings.at_once;
        const std::shared_ptr<PreparedMethods> methods =
            drawings.ready(first, std::min(drawings.methods, first + drawings.at_once));
        std::vector<Turn> turns;
        for (const auto& method : *methods) {
            for (const raster::SkipSet& skips : drawings.skips)
                turns.push_back({method.get(), skips});
        }
        std::vector<Evaluation> some = method_evaluations(turns, drawings.shot, measure);
        for (std::size_t i = 0; i < some.size(); ++i) {
            const std::size_t n = first * turns_each + i;
            if (drawings.see) drawings.see(n, turns[i], some[i]);
            drawn[n] = std::move(some[i]);
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
    if (options.line_width_px && options.scores != Scores::settings)
        score_grey_lines(traced.truth, *options.line_width_px, evaluations);
    if (options.scores_crowded && emptiness(traced.truth).empty()) return;
    note_crowded(traced.truth, evaluations);
}

}  // namespace ink::harness
