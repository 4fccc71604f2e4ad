#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "harness/method_configs.h"
#include "raster/skips.h"
#include "studies/skip_scenes.h"

namespace ink::studies {

/// How the worth of skips is measured.
struct SkipStudyOptions {
    int width_px = 1280;
    int height_px = 720;
    int threads = 1;                ///< of the methods
    int levels = kSkipSceneLevels;  ///< of the scenes, see studies/skip_scenes.h
    int min_rounds = 3;
    int max_rounds = 30;
    double budget_s = 0.3;  ///< a method on a scene stops after this much drawing
};

/// What a method may skip while it is timed.
enum class SkipArm {
    on,       ///< everything
    one_off,  ///< everything but the skip of the scene
    all_off,  ///< nothing
};

/// How fast one method draws one scene in one arm: a line of skips.csv.
struct SkipTime {
    std::string scene;
    std::optional<raster::Skip> skip;  ///< the scene's; none: one of the three views
    std::string method;
    std::string params;
    SkipArm arm = SkipArm::on;
    raster::SkipSet allowed;
    std::int64_t triangles = 0;
    std::optional<std::int64_t> draw_ns;  ///< median over drawings
    std::optional<std::int64_t> draw_ns_min;
    int draw_n = 0;
    raster::SkipCounts counts = {};  ///< of one round: a frame, or the frames of a sequence
    std::string image_hash;          ///< over the frames of a round
    std::string status = "ok";
};

/// Draws `scene` with the method: with every skip, without the scene's own, without any; in turns,
/// so that a machine that slows down slows all alike.
///
/// The three views have no skip of their own, and so no second line. Where nothing moves,
/// `temporal_reuse` is off in every arm (skips_of_repeated_drawings). Where something does, the
/// first frame of a round is not timed, nor is `pose`. The first round warms up. A method that
/// throws says so in the status of its lines; so does one whose image is another than with every
/// skip: "differs: ...".
[[nodiscard]] std::vector<SkipTime> time_skips(const harness::MethodConfig& config,
                                               const SkipScene& scene,
                                               const SkipStudyOptions& options);

/// How many scenes studies/skip_scenes.h has, and the name of the n-th.
[[nodiscard]] std::size_t skip_scene_count();
[[nodiscard]] std::string skip_scene_name(std::size_t n);

/// Times the n-th scene with every configuration, one after the other. Ends early on Ctrl-C.
[[nodiscard]] std::vector<SkipTime> study_skip_scene(
    const std::vector<harness::MethodConfig>& configs,
    std::size_t n,
    const SkipStudyOptions& options);

/// A sentence for each line whose image differs: a run with one is invalid.
[[nodiscard]] std::vector<std::string> skip_differences(const std::vector<SkipTime>& study);

}  // namespace ink::studies
