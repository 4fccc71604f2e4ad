#include "harness/view_cells.h"

#include <fmt/format.h>

#include <iterator>
#include <new>

#include "core/hash.h"
#include "core/parallel.h"

namespace ink::harness {
namespace {

/// Adds brackets, and writes into every row what does not depend on its score.
void prepare_rows(const scene::Scene& scene,
                  const scene::View& view,
                  const TracedView& traced,
                  const CellOptions& options,
                  std::vector<Shot>& shots) {
    std::vector<Shot> brackets = bracket_shots(traced.truth);
    std::move(brackets.begin(), brackets.end(), std::back_inserter(shots));
    for (Shot& shot : shots) {
        if (!traced.has_truth()) shot.row.status = traced.failure;
        fill_place(scene, view, options, shot.row);
        if (shot.row.cost) shot.row.cost->frame = traced.counts;
    }
    if (traced.check) note_witness(*traced.check, shots);
}

}  // namespace

TracedView trace_with_facts(truth::SceneModel& model,
                            const scene::Scene& scene,
                            const scene::View& view,
                            const TraceOptions& trace) {
    TracedView traced;
    traced.counts = count_frame(scene, view);
    try {
        traced.truth = trace_view(model, view, trace.cache);
        if (trace.witness) {
            traced.check = harness::cached_witness(model, view, traced.truth.traced, trace.cache);
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
    row.split = scene.split == scene::Split::train ? "train" : "heldout";
    row.width = view.width_px;
    row.height = view.height_px;
    row.threads = options.measure.threads;
    row.seed = options.seed;
    row.weld_epsilon = options.trace.truth.weld_epsilon;
    row.triangles = static_cast<std::int64_t>(scene::triangle_count(scene));
}

void finish_shots(const scene::Scene& scene,
                  const scene::View& view,
                  const TracedView& traced,
                  const CellOptions& options,
                  std::vector<Shot>& shots) {
    prepare_rows(scene, view, traced, options, shots);
    if (traced.has_truth()) score_shots(traced.truth, shots);
}

void finish_briefly(const scene::Scene& scene,
                    const scene::View& view,
                    const TracedView& traced,
                    const CellOptions& options,
                    std::vector<Shot>& shots) {
    prepare_rows(scene, view, traced, options, shots);
    if (!traced.has_truth()) return;
    // Scores are not timed, so they may use every core.
    core::parallel_for(shots.size(), core::hardware_threads(), [&](std::size_t i) {
        Shot& shot = shots[i];
        if (!shot.row.is_ok()) return;
        const score::ScoreOptions at_2px = score_options(shot.threshold);
        fill_score_2px(score::score(shot.picture, traced.truth.scoring, at_2px), shot.row);
        shot.row.image_hash = core::image_hash(shot.picture);
    });
    for (Shot& shot : shots)
        fill_truth_facts(traced.truth, shot.row);
}

}  // namespace ink::harness
