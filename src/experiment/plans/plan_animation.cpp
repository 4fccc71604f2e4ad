#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "core/error.h"
#include "core/param.h"
#include "experiment/experiment_plan.h"
#include "harness/rows/row_table.h"
#include "studies/motion_study.h"

namespace ink::experiment {
namespace {

constexpr int kBaselines = 3;  // of a sequence: sampled, exact_corner and oracle

/// Every scene along every path that was asked for.
std::vector<studies::Sequence> sequences_along(const Experiment& experiment,
                                               const studies::SequenceFrames& frames) {
    std::vector<studies::Sequence> all;
    for (const std::string& scene : experiment.scenes) {
        for (const scene::PathKind kind : scene::path_kinds()) {
            const auto& paths = experiment.animation.paths;
            if (std::find(paths.begin(), paths.end(), scene::name(kind)) != paths.end())
                all.push_back(studies::sequence_along(kind, scene, frames));
        }
    }
    return all;
}

/// The sequences of the study whose scene takes part, or those that were asked for.
std::vector<studies::Sequence> sequences_of(const Experiment& experiment, const ImageSize& size) {
    const AnimationRequest& asked = experiment.animation;
    const studies::SequenceFrames frames{
        size.width_px, size.height_px, asked.frames, asked.step_px};
    if (!asked.paths.empty()) return sequences_along(experiment, frames);
    std::vector<studies::Sequence> all = studies::study_sequences(frames);
    std::vector<std::string> known;
    for (const studies::Sequence& sequence : all)
        known.push_back(sequence.scene.name);
    known.erase(std::unique(known.begin(), known.end()), known.end());
    for (const std::string& scene : experiment.scenes) {
        if (std::find(known.begin(), known.end(), scene) != known.end()) continue;
        throw core::Error(experiment.where,
                          fmt::format("no sequence is made of scene '{}'", scene),
                          core::known_names(known, scene));
    }
    std::erase_if(all, [&](const studies::Sequence& sequence) {
        const auto& wanted = experiment.scenes;
        return !wanted.empty() &&
               std::find(wanted.begin(), wanted.end(), sequence.scene.name) == wanted.end();
    });
    return all;
}

/// What the blocks share.
struct Stage {
    std::vector<method::MethodConfig> configs;
    harness::TraceOptions trace;
    std::vector<studies::Sequence> sequences;
    std::optional<double> line_width_px;  ///< of grey lines, if they are scored
};

BlockResult run_sequence(Stage& stage, std::size_t n, int threads, std::int64_t first_cell) {
    harness::CellOptions options{{.threads = threads}, stage.trace};
    options.line_width_px = stage.line_width_px;
    const std::vector<studies::MotionRow> rows =
        studies::study_sequence(stage.configs, stage.sequences[n], options);
    BlockResult result;
    std::int64_t cell = first_cell;
    for (const studies::MotionRow& row : rows) {
        result.lines["rows.csv"] += harness::row_line(cell, harness::Study::motion, row);
        result.lines["motion.csv"] += studies::motion_table().line(cell, row);
        if (stage.line_width_px)
            result.lines["ink_motion.csv"] += studies::ink_motion_table().line(cell, row);
        result.lines["lives.csv"] += studies::life_lines(cell, row);
        ++cell;
    }
    result.faults = studies::motion_faults(rows);
    return result;
}

void plan_sequences(const Experiment& experiment, const std::shared_ptr<Stage>& stage, Plan& plan) {
    const int rows = static_cast<int>(stage->configs.size()) + kBaselines;
    for (const ImageSize& size : experiment.sizes) {
        for (studies::Sequence& sequence : sequences_of(experiment, size)) {
            const std::size_t n = stage->sequences.size();
            const double mpx = 1e-6 * size.width_px * size.height_px;
            const auto triangles = static_cast<double>(scene::triangle_count(sequence.scene));
            const double frame_s = 0.005 + rows * (0.03 * mpx + 5e-8 * triangles);
            for (const int threads : experiment.threads) {
                const std::int64_t first_cell = plan.take_cells(rows);
                plan.blocks.push_back({fmt::format("motion {} {} {} {}x{} threads {}",
                                                   n + 1,
                                                   sequence.scene.name,
                                                   scene::name(sequence.path.kind),
                                                   size.width_px,
                                                   size.height_px,
                                                   threads),
                                       rows,
                                       experiment.animation.frames * frame_s,
                                       true,
                                       [stage, n, threads, first_cell] {
                                           return run_sequence(*stage, n, threads, first_cell);
                                       }});
            }
            stage->sequences.push_back(std::move(sequence));
        }
    }
}

}  // namespace

void plan_animation(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan) {
    const auto stage = std::make_shared<Stage>();
    stage->configs = configs_of(experiment);
    // Methods from outside have no frames of a sequence.
    std::erase_if(stage->configs, [](const auto& config) { return config.is_outside; });
    stage->trace = trace;
    stage->line_width_px = scored_width_px(experiment);
    plan.add_table(harness::rows_table());
    plan.add_table(studies::motion_table());
    if (stage->line_width_px) plan.add_table(studies::ink_motion_table());
    plan.add_table(studies::lives_table());
    plan_sequences(experiment, stage, plan);
}

}  // namespace ink::experiment
