#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/tables/table.h"
#include "harness/suite/suite.h"
#include "method/method_config.h"
#include "raster/skips.h"
#include "shade/shading.h"

namespace ink::studies {

/// How an animation is timed.
struct TimedemoOptions {
    std::vector<method::MethodConfig> configs;
    int frames = 60;        ///< of a path, spread evenly over the animation; stored ones whole
    int cached_passes = 2;  ///< over the same frames again, after the first
    int threads = 1;
    raster::SkipSet skips = {};
    std::uint64_t seed = 0;  ///< of the shaking camera
};

/// What one frame of one pass took. Fill and shadings are measured once a frame and stand in every
/// method's line.
struct DemoFrame {
    /// How the camera moved: orbit, dolly, shake; pan and roll for an eye inside; `own` as the
    /// model's animation moves it.
    std::string path;
    std::string method;  ///< as registered
    int pass = 0;        ///< 0: every frame for the first time
    int frame = 0;
    double time_s = 0;          ///< of the animation
    std::int64_t fill_ns = 0;   ///< the surface moved and filled with one tone
    std::int64_t shade_ns = 0;  ///< Gouraud's shading, its own rasterization included
    std::int64_t toon_ns = 0;   ///< the toon table's shading likewise
    /// Of the method; of the very first frame, with its prepare: codes are of that frame's pose.
    std::int64_t pose_ns = 0;
    std::int64_t draw_ns = 0;
    std::int64_t compose_ns = 0;  ///< the lines put over the shading
    std::string image_hash;       ///< of the edge responses
};

/// Draws the scene's animation (or its still scene) along each path with every method in turns,
/// frame by frame; the camera starts at the scene's first view. If that is one of the model's own
/// cameras and the animation moves it, it goes its own way first. Frames that a method drew before
/// must come out the same again: throws Error (where = the method) if not. Once an end was asked
/// for (interrupt.h) there are no frames.
[[nodiscard]] std::vector<DemoFrame> run_timedemo(const harness::SceneViews& scene_views,
                                                  const TimedemoOptions& options);

/// Frames per second of one kind of frame, the median and its 95 % interval (of order statistics).
struct DemoRate {
    std::string path;
    std::string method;  ///< "" for what is the same for all methods
    std::string drawn;   ///< plain, shading, no edges, full, toon: see timedemo_legend
    bool is_cached = false;
    double fps = 0;
    double low_fps = 0;
    double high_fps = 0;
};

/// The rates of all paths, methods and kinds, as TechnicalQuake's table has them: of every frame's
/// first time, and of frames that were drawn before. Kinds without frames are not there.
[[nodiscard]] std::vector<DemoRate> timedemo_rates(const std::vector<DemoFrame>& frames);

/// The rates as a table: a line for each method and kind, two columns for each path. "" for no
/// frames.
[[nodiscard]] std::string timedemo_table(const std::vector<DemoFrame>& frames);

/// What the words of the table mean, a line each.
[[nodiscard]] std::string timedemo_legend();

/// Whether the shadings are lit by the scene's own lights; else by the studio's.
[[nodiscard]] bool has_own_lights(const harness::SceneViews& scene_views);

/// What is shown, in a line: scene, seconds, stored frames, size, threads, lights.
[[nodiscard]] std::string timedemo_heading(const harness::SceneViews& scene_views,
                                           const TimedemoOptions& options);

/// Writes timedemo.csv: a line per frame, pass, path and method.
void write_timedemo(const harness::SceneViews& scene_views,
                    const std::vector<DemoFrame>& frames,
                    const std::filesystem::path& path);

/// The median of `values` and the range of values that holds it with 95 % confidence: the order
/// statistics n/2 -+ 0.98 sqrt(n) (David and Nagaraja 2003, section 7.1), at most the extremes.
struct MedianRange {
    std::int64_t median = 0;
    std::int64_t low = 0;
    std::int64_t high = 0;
};
[[nodiscard]] MedianRange median_range(std::vector<std::int64_t> values);

}  // namespace ink::studies
