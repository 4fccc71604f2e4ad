#include <fmt/format.h>

#include <memory>

#include "core/error.h"
#include "core/parallel.h"
#include "experiment/experiment_plan.h"
#include "studies/stress/stress_axes.h"
#include "studies/stress/stress_rows.h"
#include "studies/stress_table.h"

namespace ink::experiment {
namespace {

constexpr int kBaselines = 4;

/// What the blocks share.
struct Stage {
    std::vector<harness::MethodConfig> configs;
    harness::MeasureOptions measure;
    harness::TraceOptions trace;
    studies::StressSize size;
    std::uint64_t seed = 0;
};

std::vector<const studies::StressAxis*> axes_of(const Experiment& experiment) {
    std::vector<const studies::StressAxis*> axes;
    for (const std::string& name : experiment.axes)
        axes.push_back(&studies::find_stress_axis(name));
    if (!axes.empty()) return axes;
    for (const studies::StressAxis& axis : studies::stress_axes())
        axes.push_back(&axis);
    return axes;
}

/// Counts that must be 0, in words; "" if they are.
std::string fault_of(const studies::StressRow& row) {
    if (row.counts.is_clean()) return "";
    return fmt::format(
        "{} on {} {}: {} numbers not finite, {} overflows, {} cells lost, {} images differ",
        row.row.method,
        row.axis,
        row.value,
        row.counts.non_finite,
        row.counts.overflow,
        row.counts.lost,
        row.counts.differing);
}

/// Every case of some values of an axis; `first_cell` is the number of its first row.
BlockResult run_values(const Stage& stage,
                       const studies::StressAxis& axis,
                       const std::vector<double>& values,
                       std::int64_t first_cell) {
    std::vector<studies::StressRow> rows;
    for (const double value : values) {
        for (const studies::StressCase& stress : axis.cases(value, stage.size)) {
            auto more = studies::stress_rows(stress, stage.configs, stage.measure, stage.trace);
            std::move(more.begin(), more.end(), std::back_inserter(rows));
        }
    }
    studies::note_differences(rows);
    BlockResult result;
    std::int64_t cell = first_cell;
    for (studies::StressRow& row : rows) {
        row.row.seed = stage.seed;
        result.lines["rows.csv"] += harness::row_line(cell, harness::Study::stress, row.row);
        result.lines["stress.csv"] += studies::stress_line(cell, row);
        ++cell;
        if (std::string fault = fault_of(row); !fault.empty())
            result.faults.push_back(std::move(fault));
    }
    return result;
}

/// Values whose images are compared with each other belong together; others stand alone.
std::vector<std::vector<double>> value_groups(const studies::StressAxis& axis, int points) {
    const std::vector<double> values =
        points > 0 ? studies::stress_values(axis, points) : axis.values;
    if (axis.same_images) return {values};
    std::vector<std::vector<double>> groups;
    for (const double value : values)
        groups.push_back({value});
    return groups;
}

}  // namespace

void plan_stress(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan) {
    const auto stage = std::make_shared<Stage>();
    stage->configs = configs_of(experiment);
    stage->trace = trace;
    stage->seed = experiment.seed;
    stage->trace.truth.threads = core::hardware_threads();
    stage->size = {experiment.sizes.front().width_px, experiment.sizes.front().height_px};
    plan.add_table(harness::rows_table());
    plan.add_table(studies::stress_table());
    const double mpx = 1e-6 * stage->size.width_px * stage->size.height_px;
    const int rows = static_cast<int>(stage->configs.size()) + kBaselines;
    for (const studies::StressAxis* axis : axes_of(experiment)) {
        // The cases of the first value stand for all: those of the last may be large.
        const auto cases = static_cast<int>(axis->cases(axis->values.front(), stage->size).size());
        for (const std::vector<double>& values : value_groups(*axis, experiment.points)) {
            const int cells = rows * cases * static_cast<int>(values.size());
            const std::int64_t first_cell = plan.take_cells(cells);
            plan.blocks.push_back({fmt::format("{} {}", axis->name, fmt::join(values, " ")),
                                   cells,
                                   cells * (0.01 + 0.05 * mpx),
                                   true,
                                   [stage, axis, values, first_cell] {
                                       return run_values(*stage, *axis, values, first_cell);
                                   }});
        }
    }
}

}  // namespace ink::experiment
