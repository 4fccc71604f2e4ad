#include <fmt/format.h>

#include <memory>

#include "core/error.h"
#include "experiment/experiment_plan.h"
#include "harness/suite.h"
#include "linear_code/bound_tables.h"
#include "linear_code/linear_bound_study.h"

namespace ink::experiment {
namespace {

/// What is searched, over all scenes: what one scene's search found is tried first on the pools, so
/// that they belong together.
BlockResult run_bounds(const std::vector<harness::SceneViews>& scenes,
                       const linear_code::BoundStudyOptions& options,
                       std::uint64_t seed) {
    const scene::View& view = scenes.front().views.front();
    BlockResult result;
    std::int64_t cell = 0;
    for (const linear_code::BoundRow& bound : linear_code::study_bounds(scenes, options)) {
        harness::Row row = linear_code::bound_row(bound, options, view.width_px, view.height_px);
        row.seed = seed;
        result.lines["rows.csv"] += harness::row_line(cell, harness::Study::bound, row);
        result.lines["bound.csv"] += linear_code::bound_table().line(cell, bound);
        ++cell;
    }
    return result;
}

}  // namespace

void plan_bound(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan) {
    const std::vector<method::MethodConfig> configs = configs_of(experiment);
    if (configs.size() != 1) {
        throw core::Error(experiment.where,
                          fmt::format("a bound is of one method, not of {}", configs.size()),
                          "mote4, or another method whose code is a linear sum");
    }
    linear_code::BoundStudyOptions options;
    options.config = configs.front();
    options.is_signed = experiment.bound.is_signed;
    options.least_threshold = experiment.bound.least_threshold;
    options.search.gap = experiment.bound.gap;
    options.search.most_boxes = experiment.bound.boxes;
    options.search.threads = experiment.threads.front();
    options.trace = trace;
    linear_code::check_bound(options);
    harness::ViewRequest request = experiment.view_request;
    request.width_px = experiment.sizes.front().width_px;
    request.height_px = experiment.sizes.front().height_px;
    const auto scenes = std::make_shared<const std::vector<harness::SceneViews>>(
        harness::load_scenes(experiment.scenes, request));
    for (const harness::SceneViews& scene_views : *scenes)
        plan.add_model(scene_views.scene);
    plan.add_table(harness::rows_table());
    plan.add_table(linear_code::bound_table());
    const int cells = static_cast<int>(scenes->size()) + 3;
    (void)plan.take_cells(cells);
    plan.blocks.push_back(
        {fmt::format("bound of {}", options.config.info->name),
         cells,
         10.0 * static_cast<double>(scenes->size()),
         true,
         [scenes, options, seed = experiment.seed] { return run_bounds(*scenes, options, seed); }});
}

}  // namespace ink::experiment
