#include <fmt/format.h>

#include <memory>

#include "experiment/experiment_plan.h"
#include "studies/scaling.h"
#include "studies/scaling_table.h"
#include "studies/skip_study.h"
#include "studies/skips_table.h"

namespace ink::experiment {
namespace {

constexpr int kMostArms = 3;

BlockResult run_sphere(const std::vector<harness::MethodConfig>& configs,
                       std::size_t sphere,
                       const studies::ScalingOptions& options,
                       std::int64_t first_cell) {
    BlockResult result;
    std::int64_t cell = first_cell;
    for (const studies::ScalingPoint& point : studies::time_sphere(configs, sphere, options)) {
        result.lines["rows.csv"] +=
            harness::row_line(cell, harness::Study::scaling, studies::scaling_row(point));
        result.lines["scaling.csv"] += studies::scaling_line(cell, point);
        ++cell;
    }
    return result;
}

BlockResult run_skips(const std::vector<harness::MethodConfig>& configs,
                      std::size_t scene,
                      const studies::SkipStudyOptions& options,
                      std::int64_t first_cell) {
    BlockResult result;
    const std::vector<studies::SkipTime> study = studies::study_skip_scene(configs, scene, options);
    std::int64_t cell = first_cell;
    for (const studies::SkipTime& time : study) {
        result.lines["rows.csv"] +=
            harness::row_line(cell, harness::Study::skips, studies::skip_row(time, options));
        result.lines["skips.csv"] += studies::skip_line(cell, time);
        ++cell;
    }
    result.faults = studies::skip_differences(study);
    return result;
}

}  // namespace

void plan_scaling(const Experiment& experiment, Plan& plan) {
    plan.add_table(harness::rows_table());
    plan.add_table(studies::scaling_table());
    const auto configs =
        std::make_shared<const std::vector<harness::MethodConfig>>(timed_configs_of(experiment));
    studies::ScalingOptions options;
    options.threads = experiment.threads.front();
    const std::vector<studies::ScalingSphere> spheres = studies::scaling_spheres();
    const int methods = static_cast<int>(configs->size());
    for (std::size_t n = 0; n < spheres.size(); ++n) {
        const int cells = methods * spheres[n].points;
        const std::int64_t first_cell = plan.take_cells(cells);
        plan.blocks.push_back(
            {fmt::format("scaling sphere of {} triangles", spheres[n].triangles),
             cells,
             methods * (0.2 * spheres[n].points + 1e-6 * static_cast<double>(spheres[n].triangles)),
             true,
             [configs, n, options, first_cell] {
                 return run_sphere(*configs, n, options, first_cell);
             }});
    }
}

void plan_skips(const Experiment& experiment, Plan& plan) {
    plan.add_table(harness::rows_table());
    plan.add_table(studies::skips_table());
    const auto configs =
        std::make_shared<const std::vector<harness::MethodConfig>>(timed_configs_of(experiment));
    studies::SkipStudyOptions options;
    options.width_px = experiment.sizes.front().width_px;
    options.height_px = experiment.sizes.front().height_px;
    options.threads = experiment.threads.front();
    const int cells = kMostArms * static_cast<int>(configs->size());
    for (std::size_t n = 0; n < studies::skip_scene_count(); ++n) {
        const std::int64_t first_cell = plan.take_cells(cells);
        plan.blocks.push_back({fmt::format("skips {}", studies::skip_scene_name(n)),
                               cells,
                               0.3 * static_cast<double>(configs->size()),
                               true,
                               [configs, n, options, first_cell] {
                                   return run_skips(*configs, n, options, first_cell);
                               }});
    }
}

}  // namespace ink::experiment
