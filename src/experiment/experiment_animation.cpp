#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "core/error.h"
#include "core/parallel.h"
#include "core/param.h"
#include "experiment/experiment_plan.h"
#include "studies/motion_study.h"
#include "studies/roll_study.h"

namespace ink::experiment {
namespace {

constexpr int kBrackets = 2;  // of a sequence: sampled and oracle
constexpr int kRollFrames = 180;
constexpr int kRollCreases = 3;

/// The first line of a table, and the rest with its line breaks.
std::pair<std::string, std::string> split_heading(const std::string& table) {
    const auto end = table.find('\n');
    return {table.substr(0, end), table.substr(end + 1)};
}

/// The sequences of the study whose scene takes part.
std::vector<studies::Sequence> sequences_of(const Experiment& experiment, const PictureSize& size) {
    std::vector<studies::Sequence> all =
        studies::study_sequences(size.width_px, size.height_px, experiment.frames);
    std::vector<std::string> known;
    for (const studies::Sequence& sequence : all)
        known.push_back(sequence.scene.name);
    known.erase(std::unique(known.begin(), known.end()), known.end());
    for (const std::string& scene : experiment.scenes) {
        if (std::find(known.begin(), known.end(), scene) != known.end()) continue;
        throw core::Error(experiment.file.string(),
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
    std::vector<harness::Entrant> entrants;
    harness::TraceOptions trace;
    std::vector<studies::Sequence> sequences;
};

BlockResult run_sequence(Stage& stage, std::size_t n, int threads) {
    studies::MotionOptions options;
    options.measure.threads = threads;
    options.trace = stage.trace;
    const std::vector<studies::MotionRow> rows =
        studies::study_sequence(stage.entrants, stage.sequences[n], options);
    return {{{"motion.csv", split_heading(studies::motion_csv(rows)).second}},
            studies::motion_faults(rows)};
}

BlockResult run_roll(const Stage& stage, int threads) {
    studies::RollOptions options;
    options.measure.threads = threads;
    options.cache = stage.trace.cache;
    options.frame_count = kRollFrames;
    const std::vector<studies::RollCurve> curves = studies::study_roll(stage.entrants, options);
    return {{{"roll.csv", split_heading(studies::roll_csv(curves)).second},
             {"vanishing.csv", split_heading(studies::vanishing_csv(curves)).second}},
            {}};
}

}  // namespace

void plan_animation(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan) {
    const auto stage = std::make_shared<Stage>();
    stage->entrants = entrants_of(experiment);
    stage->trace = trace;
    stage->trace.truth.threads = core::hardware_threads();
    const int methods = static_cast<int>(stage->entrants.size());
    plan.tables.push_back({"motion.csv", split_heading(studies::motion_csv({})).first});
    for (const PictureSize& size : experiment.sizes) {
        for (studies::Sequence& sequence : sequences_of(experiment, size)) {
            const std::size_t n = stage->sequences.size();
            const double mpx = 1e-6 * size.width_px * size.height_px;
            const auto triangles = static_cast<double>(scene::triangle_count(sequence.scene));
            const double frame_s = 0.005 + (methods + kBrackets) * (0.03 * mpx + 5e-8 * triangles);
            for (const int threads : experiment.threads) {
                plan.blocks.push_back(
                    {fmt::format("{} {} {} {}x{} threads {}",
                                 n + 1,
                                 sequence.scene.name,
                                 scene::name(sequence.path.kind),
                                 size.width_px,
                                 size.height_px,
                                 threads),
                     methods + kBrackets,
                     experiment.frames * frame_s,
                     true,
                     [stage, n, threads] { return run_sequence(*stage, n, threads); }});
            }
            stage->sequences.push_back(std::move(sequence));
        }
    }
    if (!experiment.roll) return;
    plan.tables.push_back({"roll.csv", split_heading(studies::roll_csv({})).first});
    plan.tables.push_back({"vanishing.csv", split_heading(studies::vanishing_csv({})).first});
    const int threads = experiment.threads.front();
    plan.blocks.push_back({"roll",
                           methods * kRollCreases * kRollFrames,
                           kRollFrames * (0.005 + methods * 0.002),
                           true,
                           [stage, threads] { return run_roll(*stage, threads); }});
}

}  // namespace ink::experiment
