#include "experiment/experiment_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/trigonometric.hpp>
#include <numeric>

#include "core/error.h"
#include "core/hash.h"
#include "core/named.h"
#include "core/parallel.h"
#include "core/provenance.h"
#include "core/whole_file.h"
#include "experiment/experiment.h"
#include "harness/rows/methods_table.h"

namespace ink::experiment {
namespace {

/// A model file may change while its name stays.
void add_file(const std::string& scene, core::Hasher& hasher) {
    if (const auto bytes = core::read_whole_file(scene)) hasher.text(*bytes);
}

/// All that the rows depend on: what is asked for, down to every parameter, and who answers. How
/// the answer is chosen from them is not among it.
std::string identity_of(const Experiment& experiment, const Plan& plan) {
    core::Hasher hasher;
    hasher.text(plan.build).text(core::provenance().compiler).text(core::provenance().flags);
    Experiment rows = experiment;
    rows.compare.answer = {};
    hasher.text(plan.name).text(plan.kind).text(asked_text(rows));
    for (const std::string& scene : experiment.scenes)
        add_file(scene, hasher);
    for (const RecordedTable& table : plan.tables)
        hasher.text(table.name).text(table.heading);
    for (const Block& block : plan.blocks)
        hasher.text(block.key).value(block.cells);
    return hasher.hex();
}

}  // namespace

std::string build_text() {
    const core::Provenance& p = core::provenance();
    return fmt::format("{} {}{}", p.version, p.commit, p.dirty ? ", changed" : "");
}

harness::TraceOptions trace_of(const Experiment& experiment, const std::filesystem::path& cache) {
    harness::TraceOptions trace;
    trace.cache = cache;
    trace.truth.threads = core::hardware_threads();
    trace.truth.crease_rad = glm::radians(experiment.crease_deg);
    trace.truth.creases = experiment.compare.creases;
    trace.truth.weld_epsilon = experiment.weld_epsilon;
    trace.intersections = experiment.intersections;
    return trace;
}

int Plan::cells() const {
    return std::accumulate(blocks.begin(), blocks.end(), 0, [](int sum, const Block& block) {
        return sum + block.cells;
    });
}

void RunHead::add_table(const core::TableInfo& table) {
    if (core::find_named(tables, table.file) != nullptr) return;
    std::string columns = core::heading(table);
    columns.pop_back();  // its line break
    tables.push_back({table.file, std::move(columns)});
}

void RunHead::add_model(const scene::Scene& scene) {
    if (scene.file.notes.empty() && scene.origin == glm::dvec3(0)) return;
    models.push_back({scene.name, scene.origin, scene.file.notes});
}

std::int64_t Plan::take_cells(std::int64_t count) {
    rows += count;
    return rows - count;
}

Plan make_plan(const Experiment& experiment, const std::filesystem::path& cache) {
    Plan plan;
    plan.name = experiment.name;
    plan.kind = name(experiment.kind);
    plan.command = experiment.command;
    plan.asked = asked_text(experiment);
    plan.answer = experiment.compare.answer;
    plan.times = experiment.times;
    plan.one_place = experiment.sizes.size() == 1 && experiment.threads.size() == 1;
    plan.files["methods.csv"] = harness::methods_csv(configs_of(experiment));
    for (const ImageSize& size : experiment.sizes) {
        for (const methods::Antialias antialias : experiment.antialias)
            (void)methods::enlarged({{}, size.width_px, size.height_px},
                                    methods::samples_per_side(antialias));  // or too large
    }
    const harness::TraceOptions trace = trace_of(experiment, cache);
    constexpr std::array kPlanners = {plan_compare, plan_stress, plan_animation};
    kPlanners.at(static_cast<std::size_t>(experiment.kind))(experiment, trace, plan);
    if (plan.blocks.empty()) {
        throw core::Error(experiment.where,
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
