#include "experiment/plans/compare_blocks.h"

#include <memory>
#include <span>

#include "harness/cells/sweep.h"
#include "harness/images/view_images.h"
#include "harness/rows/cost_tables.h"
#include "harness/rows/score_tables.h"
#include "linear_code/cancellation_study.h"

namespace ink::experiment {
namespace {

void add_side_tables(std::int64_t cell,
                     const harness::Evaluation& evaluation,
                     BlockResult& result) {
    if (!evaluation.row.is_ok() || evaluation.row.tolerance_sweep.empty()) return;
    result.lines["curves.csv"] += harness::curve_lines(cell, evaluation.scored.curve);
    result.lines["tolerances.csv"] +=
        harness::tolerance_lines(cell, evaluation.row.tolerance_sweep);
    result.lines["bins.csv"] += harness::bin_lines(cell, evaluation.row.bins);
}

/// The layers of what was drawn, where they are kept.
using Layers = std::vector<harness::MethodLayers>;

/// What `count` methods draw of a view, as many at a time as fit into memory; `ready` is
/// harness::ViewDrawings::ready.
template <class Ready>
std::vector<harness::Evaluation> draw(ViewBench& bench,
                                      const BlockPlace& at,
                                      std::size_t count,
                                      Ready ready,
                                      const harness::MeasureOptions& measure,
                                      Layers* layers = nullptr) {
    harness::ViewDrawings drawings{*at.view, count, bench.most_at_once(at.scene)};
    drawings.ready = ready;
    if (layers != nullptr) {
        drawings.see = [&](std::size_t, harness::PreparedMethod& method, const auto& drawn) {
            if (!drawn.row.is_ok()) return;
            layers->push_back(
                harness::buffer_layers(method, {*at.view, measure.threads, measure.skips}));
        };
    }
    return harness::draw_view(drawings, measure);
}

/// Why the scored evaluations are wrong where they are, and what codes had to miss.
void explain(ViewBench& bench,
             const BlockPlace& at,
             const harness::ViewTruth& truth,
             std::vector<harness::Evaluation>& evaluations,
             BlockResult& result) {
    harness::MissPredictor& predictor = bench.predictor(at.scene);
    harness::attribute_evaluations(truth, *at.view, predictor, evaluations);
    for (const linear_code::CancellationRow& row :
         linear_code::study_cancellation(truth, *at.view, predictor, evaluations)) {
        result.lines["cancellation.csv"] += linear_code::cancellation_table().line(
            at.first_cell + static_cast<std::int64_t>(row.evaluation), row);
    }
}

}  // namespace

BlockResult run_methods(ViewBench& bench,
                        const BlockPlace& at,
                        const harness::SweepColumns& swept) {
    const scene::Scene& scene = bench.scenes()[at.scene];
    const bool is_full = bench.experiment().compare.full_scores;
    harness::CellOptions options = bench.cell_options(at.threads);
    options.scores = is_full ? harness::Scores::full : harness::Scores::brief;
    BlockResult result;
    const std::shared_ptr<const harness::TracedView> held = bench.traced(at.scene, *at.view);
    const harness::TracedView& traced = *held;
    const bool keeps_images = at.keeps_images && traced.has_truth();
    Layers layers;
    // The same methods come again with the next view.
    const auto ready = [&](std::size_t first, std::size_t) {
        return bench.methods(at.scene, first);
    };
    std::vector<harness::Evaluation> evaluations;
    {
        const auto methods = bench.hold_methods(at.scene);
        evaluations = draw(bench,
                           at,
                           bench.configs().size(),
                           ready,
                           options.measure,
                           keeps_images ? &layers : nullptr);
    }
    harness::finish_evaluations(scene, *at.view, traced, options, evaluations);
    if (is_full && traced.has_truth()) explain(bench, at, traced.truth, evaluations, result);
    harness::check_baselines(evaluations, result.faults);
    for (std::size_t i = 0; i < evaluations.size(); ++i) {
        harness::Evaluation& evaluation = evaluations[i];
        const std::int64_t cell = at.first_cell + static_cast<std::int64_t>(i);
        if (!bench.experiment().times) clear_times(evaluation.row);
        result.lines["rows.csv"] +=
            harness::row_line(cell, harness::Study::compare, evaluation.row);
        result.lines["cost.csv"] += harness::cost_line(cell, evaluation.row);
        add_side_tables(cell, evaluation, result);
        if (i < at.sweeps_own.size() && at.sweeps_own[i])
            result.lines["sweep.csv"] += harness::sweep_line(cell, 1, swept, evaluation.row);
    }
    if (keeps_images) result.files = harness::image_files(traced.truth, scene, evaluations, layers);
    return result;
}

BlockResult run_settings(ViewBench& bench,
                         const BlockPlace& at,
                         const SettingsPart& part,
                         const harness::SweepColumns& swept) {
    harness::CellOptions options = bench.cell_options(at.threads);
    options.measure = harness::sweep_measure(options.measure, bench.scenes().size());
    options.scores = harness::Scores::settings;
    BlockResult result;
    const harness::SharedDrawings drawings(part.settings);
    const auto ready = [&](std::size_t first, std::size_t end) {
        return bench.prepared(std::span(drawings.drawn()).subspan(first, end - first), at.scene);
    };
    std::vector<harness::Evaluation> evaluations =
        drawings.shared(draw(bench, at, drawings.drawn().size(), ready, options.measure));
    harness::finish_evaluations(bench.scenes()[at.scene],
                                *at.view,
                                *bench.traced(at.scene, *at.view),
                                options,
                                evaluations);
    const std::int64_t cell = at.first_cell + static_cast<std::int64_t>(part.method);
    for (std::size_t i = 0; i < part.settings.size(); ++i) {
        if (!bench.experiment().times) clear_times(evaluations[i].row);
        result.lines["sweep.csv"] +=
            harness::sweep_line(cell, static_cast<int>(part.first + i), swept, evaluations[i].row);
    }
    return result;
}

}  // namespace ink::experiment
