#include "experiment/experiment_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <numeric>

#include "core/error.h"
#include "core/hash.h"
#include "core/provenance.h"
#include "harness/cell.h"

namespace ink::experiment {
namespace {

std::string build_text() {
    const core::Provenance& p = core::provenance();
    return fmt::format("{} {}{}", p.version, p.commit, p.dirty ? ", changed" : "");
}

/// A model file may change while its name stays.
void add_file(const std::string& scene, core::Hasher& hasher) {
    std::ifstream stream(scene, std::ios::binary);
    if (!stream || std::filesystem::is_directory(scene)) return;
    const std::string bytes{std::istreambuf_iterator<char>(stream),
                            std::istreambuf_iterator<char>()};
    hasher.text(bytes);
}

/// All that the rows depend on: what is asked for, down to every parameter, and who answers.
std::string identity_of(const Experiment& experiment, const Plan& plan) {
    core::Hasher hasher;
    hasher.text(plan.build).text(core::provenance().compiler).text(core::provenance().flags);
    hasher.text(experiment.name).value(experiment.seed);
    hasher.value(experiment.repetitions).value(experiment.budget_s).value(experiment.frames);
    hasher.value(int{experiment.full_scores}).value(int{experiment.witness});
    hasher.value(int{experiment.times});
    for (const harness::Entrant& entrant : entrants_of(experiment)) {
        hasher.text(entrant.info->name)
            .text(harness::join_params(entrant.info->complete(entrant.settings)));
    }
    for (const SettingGrid& grid : experiment.grids) {
        hasher.text(grid.method);
        for (const auto& [key, values] : grid.axes)
            hasher.text(key).text(fmt::format("{}", fmt::join(values, ",")));
    }
    for (const std::string& scene : experiment.scenes)
        add_file(scene, hasher);
    for (const PlannedTable& table : plan.tables)
        hasher.text(table.name).text(table.heading);
    for (const Block& block : plan.blocks)
        hasher.text(block.key).value(block.cells);
    return hasher.hex();
}

}  // namespace

int Plan::cells() const {
    return std::accumulate(blocks.begin(), blocks.end(), 0, [](int sum, const Block& block) {
        return sum + block.cells;
    });
}

Plan make_plan(const Experiment& experiment, const harness::TraceOptions& trace) {
    Plan plan;
    plan.name = experiment.name;
    plan.build = build_text();
    plan.times = experiment.times;
    plan.one_place = experiment.sizes.size() == 1 && experiment.threads.size() == 1;
    switch (experiment.kind) {
        case ExperimentKind::compare:
            plan_compare(experiment, trace, plan);
            break;
        case ExperimentKind::stress:
            plan_stress(experiment, trace, plan);
            break;
        case ExperimentKind::animation:
            plan_animation(experiment, trace, plan);
            break;
    }
    if (plan.blocks.empty()) {
        throw core::Error(experiment.file.string(),
                          "its grid has no cells",
                          "scenes, methods and sizes, one of each at least");
    }
    plan.identity = identity_of(experiment, plan);
    return plan;
}

std::vector<std::size_t> shard_blocks(const Plan& plan, int i, int n) {
    std::vector<std::size_t> order(plan.blocks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return plan.blocks[a].work > plan.blocks[b].work;
    });
    std::vector<double> load(static_cast<std::size_t>(n), 0);
    std::vector<std::size_t> mine;
    for (const std::size_t block : order) {
        const auto least = std::min_element(load.begin(), load.end());
        *least += plan.blocks[block].work;
        if (least - load.begin() == i - 1) mine.push_back(block);
    }
    std::sort(mine.begin(), mine.end());
    return mine;
}

}  // namespace ink::experiment
