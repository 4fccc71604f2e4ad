#include "studies/stress/stress_rows.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <new>
#include <optional>

#include "core/hash.h"
#include "core/parallel.h"
#include "core/simd.h"
#include "harness/csv.h"
#include "harness/shots.h"
#include "studies/stress/stress_counts.h"
#include "truth/limits.h"

namespace ink::studies {
namespace {

/// The truth of a case; without one, why.
struct StressTruth {
    std::optional<harness::ViewTruth> truth;
    std::string failure;
    std::int64_t non_finite = 0;
};

StressTruth trace(const StressCase& stress, const harness::TraceOptions& options) {
    StressTruth result;
    try {
        truth::SceneModel model(stress.subject.scene, options.truth);
        result.truth = harness::trace_view(model, stress.subject.views.front(), options.cache);
        result.non_finite = count_non_finite(result.truth->traced);
    } catch (const truth::TooLarge& reason) {
        result.failure = fmt::format("too_large: {}", reason.what());
    } catch (const std::bad_alloc&) {
        result.failure = "too_large: no memory to trace the truth";
    }
    return result;
}

/// Draws with one method, unscored; its picture is empty if it failed.
harness::Shot draw_shot(const harness::Entrant& entrant,
                        const scene::Scene& scene,
                        const method::Frame& frame,
                        std::int64_t& overflow) {
    std::vector<std::unique_ptr<harness::PreparedMethod>> methods;
    methods.push_back(std::make_unique<harness::PreparedMethod>(entrant, scene));
    const harness::MeasureOptions once{
        .threads = frame.threads, .min_repetitions = 0, .max_repetitions = 0, .skips = frame.skips};
    harness::Shot shot = std::move(harness::method_shots(methods, frame.view, once).front());
    shot.row.prepare_ns.reset();
    shot.row.pose_ns.reset();
    shot.row.cost.reset();
    const bool has_size = shot.picture.width_px() == frame.view.width_px &&
                          shot.picture.height_px() == frame.view.height_px;
    if (shot.row.is_ok() && !has_size) {
        shot.row.status = fmt::format(
            "failed: a picture of {} x {} px", shot.picture.width_px(), shot.picture.height_px());
    }
    if (shot.row.is_ok())
        overflow = count_overflow(methods.front()->method(), entrant, scene, frame);
    return shot;
}

void score_shot(const StressTruth& truth, harness::Shot& shot) {
    if (!truth.failure.empty()) shot.row.status = truth.failure;
    if (!shot.row.is_ok()) return;
    const score::Strokes strokes =
        score::make_strokes(shot.picture, shot.threshold, harness::score_options(shot.threshold));
    harness::fill_score_2px(
        score::score_strokes(strokes, truth.truth->scoring, harness::score_options(shot.threshold)),
        shot.row);
    shot.row.image_hash = core::image_hash(shot.picture);
    harness::fill_truth_facts(*truth.truth, shot.row);
}

}  // namespace

void StressCounts::add(const StressCounts& more) {
    non_finite += more.non_finite;
    overflow += more.overflow;
    lost += more.lost;
    differing += more.differing;
}

std::vector<StressRow> stress_rows(const StressCase& stress,
                                   const std::vector<harness::Entrant>& entrants,
                                   const harness::MeasureOptions& measure,
                                   const harness::TraceOptions& options) {
    std::optional<core::ForcedSimdTarget> forced;
    for (const core::SimdTarget& target : core::simd_targets()) {
        if (target.name == stress.simd_target) forced.emplace(target);
    }
    const scene::Scene& scene = stress.drawn ? *stress.drawn : stress.subject.scene;
    const scene::View& view = stress.subject.views.front();
    const method::Frame frame{view, stress.threads.value_or(measure.threads), measure.skips};
    const StressTruth truth = trace(stress, options);
    const StressCounts given = count_inputs(scene, view);

    std::vector<harness::Shot> shots;
    if (truth.truth) shots = harness::bracket_shots(*truth.truth);
    const std::size_t brackets = shots.size();
    shots.resize(brackets + entrants.size());
    std::vector<std::int64_t> overflow(shots.size(), 0);
    // Nothing is timed, so all may be drawn at once.
    core::parallel_for(shots.size(), core::hardware_threads(), [&](std::size_t i) {
        if (i >= brackets) {
            const harness::Entrant entrant = under_stress(entrants[i - brackets], stress);
            shots[i] = draw_shot(entrant, scene, frame, overflow[i]);
        }
        score_shot(truth, shots[i]);
        shots[i].picture = {};
    });

    const StressAxis& axis = find_stress_axis(stress.axis);
    std::vector<StressRow> rows;
    for (std::size_t i = 0; i < shots.size(); ++i) {
        harness::Row& row = shots[i].row;
        row.scene = stress.subject.scene.name;
        row.view = view.camera.name;
        row.split = stress.subject.scene.split == scene::Split::train ? "train" : "heldout";
        row.width = view.width_px;
        row.height = view.height_px;
        row.threads = frame.threads;
        row.weld_epsilon = options.truth.weld_epsilon;
        row.triangles = static_cast<std::int64_t>(scene::triangle_count(scene));
        StressCounts counts = given;
        counts.non_finite += truth.non_finite + count_non_finite(row);
        counts.overflow += overflow[i];
        counts.lost = row.is_ok() ? 0 : 1;
        rows.push_back({stress.axis, stress.value, axis.unit, std::move(row), counts});
    }
    return rows;
}

void note_differences(std::vector<StressRow>& rows) {
    std::map<std::string, std::string> first;  // axis, scene and method to the picture's hash
    for (StressRow& row : rows) {
        if (!row.row.is_ok() || !find_stress_axis(row.axis).same_pictures) continue;
        const std::string key =
            fmt::format("{},{},{}", row.axis, harness::csv_field(row.row.scene), row.row.method);
        const auto [known, is_new] = first.try_emplace(key, row.row.image_hash);
        row.counts.differing = known->second == row.row.image_hash ? 0 : 1;
    }
}

}  // namespace ink::studies
