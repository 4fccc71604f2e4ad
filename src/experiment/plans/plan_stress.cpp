#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <memory>
#include <utility>

#include "core/interrupt.h"
#include "core/parallel.h"
#include "experiment/experiment_plan.h"
#include "harness/cells/cell.h"
#include "harness/rows/row_table.h"
#include "studies/axis.h"
#include "studies/axis_rows.h"

namespace ink::experiment {
namespace {

/// What the blocks of an axis share.
struct Stage {
    studies::Axis axis;
    std::vector<method::MethodConfig> configs;
    harness::CellOptions options;
    studies::CaseSize size;
    scene::ProjectionKind projection = scene::ProjectionKind::perspective;
};

/// The cases of a value, under the projection that was asked for.
std::vector<studies::Case> cases_of(const Stage& stage, double value) {
    std::vector<studies::Case> cases = stage.axis.cases(value, stage.size);
    for (studies::Case& one : cases) {
        const scene::Sphere bounds = scene::bounding_sphere(one.scene_views.scene);
        for (scene::View& view : one.scene_views.views)
            view.camera = scene::projected(stage.projection, view.camera, bounds);
    }
    return cases;
}

/// Why the whole run would be invalid, in words; "" if it is not.
std::string fault_of(const studies::AxisRow& of) {
    if (of.faults.is_clean()) return "";
    return fmt::format(
        "{} on {} {}: {} numbers not finite, {} overflows, {} cells lost, {} images differ",
        of.row.method,
        of.row.axis,
        *of.row.value,
        of.faults.non_finite,
        of.faults.overflow,
        of.faults.lost,
        of.faults.differing);
}

/// Every case of some values of an axis; `first_cell` is the number of its first row.
BlockResult run_values(const Stage& stage,
                       const std::vector<double>& values,
                       std::int64_t first_cell) {
    const studies::Axis& axis = stage.axis;
    std::vector<studies::AxisRow> rows;
    for (const double value : values) {
        for (const studies::Case& one : cases_of(stage, value)) {
            if (core::is_interrupted()) return {};
            auto more = studies::axis_rows(one, stage.configs, stage.options);
            std::move(more.begin(), more.end(), std::back_inserter(rows));
        }
    }
    studies::note_differences(axis, rows);
    BlockResult result;
    std::int64_t cell = first_cell;
    for (const studies::AxisRow& of : rows) {
        result.lines["rows.csv"] += harness::row_line(cell, harness::Study::stress, of.row);
        result.lines["stress.csv"] += studies::faults_table().line(cell, of);
        ++cell;
        if (std::string fault = fault_of(of); !fault.empty())
            result.faults.push_back(std::move(fault));
    }
    return result;
}

/// Values that are looked at together, and others alone.
std::vector<std::vector<double>> value_groups(const studies::Axis& axis, int points) {
    const std::vector<double> values =
        points > 0 ? studies::axis_values(axis, points) : axis.values;
    if (axis.same_images) return {values};
    std::vector<std::vector<double>> groups;
    for (const double value : values)
        groups.push_back({value});
    return groups;
}

/// The rows of a value: those of the first stand for all, as those of the last may be large.
int rows_of_value(const Stage& stage) {
    const auto cases = stage.axis.cases(stage.axis.values.front(), stage.size).size();
    return static_cast<int>((stage.configs.size() + harness::kBaselines) * cases);
}

/// Blocks of every value of an axis, alone on the machine.
void plan_axis(const std::shared_ptr<Stage>& stage, int points, Plan& plan) {
    const studies::Axis& axis = stage->axis;
    const double mpx = 1e-6 * stage->size.width_px * stage->size.height_px;
    const double cell_s = 0.01 + 0.05 * mpx;
    const int rows = rows_of_value(*stage);
    for (const std::vector<double>& values : value_groups(axis, points)) {
        const int cells = rows * static_cast<int>(values.size());
        const std::int64_t first_cell = plan.take_cells(cells);
        plan.blocks.push_back(
            {values.size() < 20 ? fmt::format("{} {}", axis.name, fmt::join(values, " "))
                                : axis.name,
             cells,
             cells * cell_s,
             true,
             [stage, values, first_cell] { return run_values(*stage, values, first_cell); }});
    }
}

}  // namespace

void plan_stress(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan) {
    std::vector<studies::Axis> axes;
    for (const std::string& name : experiment.stress.axes)
        axes.push_back(studies::find_stress_axis(name));
    if (axes.empty()) axes = studies::stress_axes();
    plan.add_table(harness::rows_table());
    plan.add_table(studies::faults_table());
    plan.files["axes.csv"] = studies::axes_table().file(axes);
    for (const studies::Axis& axis : axes) {
        const auto stage = std::make_shared<Stage>();
        stage->axis = axis;
        stage->configs = configs_of(experiment);
        stage->options = {{}, trace, experiment.seed};
        stage->options.line_width_px = scored_width_px(experiment);
        stage->options.trace.truth.threads = core::hardware_threads();
        stage->options.measure.threads = experiment.threads.front();
        stage->options.measure.skips = harness::skips_of_repeated_drawings();
        stage->projection = experiment.stress.projection;
        stage->size = {experiment.sizes.front().width_px, experiment.sizes.front().height_px};
        plan_axis(stage, experiment.stress.points, plan);
    }
}

}  // namespace ink::experiment
