#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "core/error.h"
#include "experiment/experiment_plan.h"
#include "experiment/plans/compare_blocks.h"
#include "experiment/view_bench.h"
#include "harness/rows/cost_tables.h"
#include "harness/rows/score_tables.h"
#include "harness/suite/suite.h"
#include "linear_code/cancellation_study.h"
#include "studies/hardest/hardest_table.h"
#include "studies/hardest/hardest_view.h"

namespace ink::experiment {
namespace {

/// What the blocks of a search share.
struct HardestStudy {
    Experiment experiment;
    harness::TraceOptions trace;
    std::vector<harness::SceneViews> scenes;
};

/// A block: one scene, one method.
struct StudyBlock {
    std::size_t scene = 0;
    studies::HardestOptions options;
    std::int64_t first_cell = 0;
    int cells_of_view = 0;
};

const method::MethodConfig& config_called(const std::vector<method::MethodConfig>& configs,
                                          const std::string& name) {
    return *std::find_if(configs.begin(), configs.end(), [&](const method::MethodConfig& config) {
        return config.info->name == name;
    });
}

studies::HardestOptions options_of(const HardestStudy& study, const std::string& method) {
    const std::vector<method::MethodConfig> configs = configs_of(study.experiment);
    const HardestRequest& asked = study.experiment.hardest;
    studies::HardestOptions options{config_called(configs, method)};
    if (!asked.against.empty()) options.against = config_called(configs, asked.against);
    options.evaluations = asked.evaluations;
    options.seed = study.experiment.seed;
    options.least_truth_px = asked.least_truth_px;
    options.worst = asked.worst;
    options.cell = {{}, study.trace, study.experiment.seed};
    options.cell.line_width_px = scored_width_px(study.experiment);
    options.cell.measure.threads = study.experiment.threads.front();
    return options;
}

/// Searches, and draws what it found as a comparison does: rows, causes, images.
BlockResult run_block(const HardestStudy& study, const StudyBlock& block) {
    const harness::SceneViews& scene_views = study.scenes[block.scene];
    const auto looks = studies::search_hardest_views(scene_views, block.options);
    if (!looks) return {};
    BlockResult result;
    const auto looks_table = studies::hardest_table(study.experiment.coverage);
    for (const studies::HardestLook& look : *looks)
        result.lines["hardest.csv"] += looks_table.line(look);
    ViewBench bench(study.experiment, study.trace, studies::worst_scene_views(scene_views, *looks));
    std::int64_t cell = block.first_cell;
    for (std::size_t s = 0; s < bench.scenes().size(); ++s) {
        const scene::View& view = bench.view(s, study.experiment.sizes.front(), 0);
        BlockResult of_view =
            run_methods(bench, {s, &view, study.experiment.threads.front(), cell, true, true});
        for (auto& [table, lines] : of_view.lines)
            result.lines[table] += lines;
        result.files.merge(of_view.files);
        std::move(of_view.faults.begin(), of_view.faults.end(), std::back_inserter(result.faults));
        cell += block.cells_of_view;
        bench.release(s);
    }
    return result;
}

/// Throws core::Error unless there is something to search, and one size.
void check_study(const Experiment& experiment) {
    const HardestRequest& asked = experiment.hardest;
    if (asked.methods.empty())
        throw core::Error(experiment.where, "no method is searched", "search.methods = METHOD");
    if (experiment.scenes.empty())
        throw core::Error(
            experiment.where, "no scene is searched", "--scenes SCENE, or grid.scenes in a file");
    if (experiment.sizes.size() != 1 || experiment.threads.size() != 1)
        throw core::Error(experiment.where, "a search has several sizes or threads", "one of each");
    if (std::find(asked.methods.begin(), asked.methods.end(), asked.against) != asked.methods.end())
        throw core::Error(experiment.where,
                          fmt::format("{} cannot lose to itself", asked.against),
                          "another method against it");
}

/// Seconds for a block, roughly, on two cores without other work.
double work_s(const HardestStudy& study, const StudyBlock& block) {
    const ImageSize& size = study.experiment.sizes.front();
    const double mpx = 1e-6 * size.width_px * size.height_px;
    const auto triangles =
        static_cast<double>(scene::triangle_count(study.scenes[block.scene].scene));
    return study.experiment.hardest.evaluations * (0.01 + 0.2 * mpx + 2e-7 * triangles);
}

}  // namespace

void plan_hardest(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan) {
    check_study(experiment);
    const auto study = std::make_shared<HardestStudy>(HardestStudy{experiment, trace, {}});
    study->experiment.compare.images = KeptImages::all;
    study->scenes = harness::load_scenes(experiment.scenes, views_of(experiment));
    for (const harness::SceneViews& scene_views : study->scenes)
        plan.add_model(scene_views.scene);
    plan.add_table(harness::rows_table());
    plan.add_table(harness::cost_table());
    plan.add_table(harness::curves_table());
    plan.add_table(harness::tolerances_table());
    plan.add_table(harness::bins_table());
    plan.add_table(linear_code::cancellation_table());
    plan.add_table(studies::hardest_table(experiment.coverage));
    const int cells_of_view = static_cast<int>(configs_of(experiment).size()) + harness::kBaselines;
    for (std::size_t s = 0; s < study->scenes.size(); ++s) {
        for (const std::string& method : experiment.hardest.methods) {
            StudyBlock block{s, options_of(*study, method), 0, cells_of_view};
            const int cells = experiment.hardest.worst * cells_of_view;
            block.first_cell = plan.take_cells(cells);
            plan.blocks.push_back(
                {fmt::format("hardest views of {} for {}", study->scenes[s].scene.name, method),
                 cells,
                 work_s(*study, block),
                 true,
                 [study, block] { return run_block(*study, block); },
                 s});
        }
    }
}

}  // namespace ink::experiment
