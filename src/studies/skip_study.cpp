#include "studies/skip_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/hash.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "harness/cell.h"
#include "harness/skip_switches.h"

namespace ink::studies {
namespace {

using Clock = std::chrono::steady_clock;

bool knows(const method::MethodInfo& info, const std::string& key) {
    return std::any_of(info.params.begin(), info.params.end(), [&](const core::Param& param) {
        return param.name == key;
    });
}

/// The configuration with those settings of the scene that its method knows.
harness::MethodConfig config_for(harness::MethodConfig config, const SkipScene& scene) {
    for (const auto& [key, value] : scene.settings) {
        if (knows(*config.info, key)) config.settings[key] = value;
    }
    return config;
}

raster::SkipSet skips_of(SkipArm arm, const SkipScene& scene) {
    if (arm == SkipArm::all_off) return raster::SkipSet::none();
    raster::SkipSet allowed =
        scene.poses.empty() ? harness::skips_of_repeated_drawings() : raster::SkipSet();
    if (arm == SkipArm::one_off) allowed.set(*scene.skip, false);
    return allowed;
}

void add(const raster::SkipCounts& counts, raster::SkipCounts& sums) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i].skipped += counts[i].skipped;
        sums[i].of += counts[i].of;
    }
}

/// One drawing of a scene, or one run through its sequence.
struct Round {
    std::vector<std::int64_t> draw_ns;  ///< of the timed frames
    raster::SkipCounts counts = {};     ///< summed over them
    std::string hash;                   ///< over all frames
};

/// A method before a scene, ready to draw it in any arm.
class Easel {
  public:
    Easel(const harness::MethodConfig& config,
          const SkipScene& scene,
          const SkipStudyOptions& options)
        : poses_(scene.poses),
          scene_(scene.scene),
          view_{scene_.cameras.front(), options.width_px, options.height_px},
          threads_(options.threads),
          method_(config.info->make(config.settings)),
          image_(options.width_px, options.height_px) {
        method_->prepare(scene_);
        method_->pose(scene_);
    }

    Round draw(const raster::SkipSet& allowed) {
        Round round;
        core::Hasher hasher;
        const std::size_t frames = std::max<std::size_t>(1, poses_.size());
        for (std::size_t frame = 0; frame < frames; ++frame) {
            if (!poses_.empty()) {
                scene_.instances.front().world_from_object = poses_[frame];
                method_->pose(scene_);
            }
            const auto start = Clock::now();
            method_->draw({view_, threads_, allowed}, image_);
            const auto end = Clock::now();
            hasher.text(core::image_hash(image_));
            // The first frame of a sequence follows the last of another run: it is not of this one.
            if (frame == 0 && frames > 1) continue;
            round.draw_ns.push_back(
                std::chrono::duration_cast<std::chrono::nanoseconds>(end - start).count());
            add(method_->skip_counts(), round.counts);
        }
        round.hash = hasher.hex();
        return round;
    }

  private:
    const std::vector<glm::dmat4>& poses_;
    scene::Scene scene_;
    scene::View view_;
    int threads_;
    std::unique_ptr<method::Method> method_;
    edge::EdgeImage image_;
};

void fill_times(std::vector<std::int64_t> draw_ns, SkipTime& time) {
    harness::Row row;
    fill_times(std::move(draw_ns), row);
    time.draw_ns = row.draw_ns;
    time.draw_ns_min = row.draw_ns_min;
    time.draw_n = row.draw_n;
}

/// Draws all `times` in turns, the first of them being the one the others must equal.
void draw_in_turns(Easel& easel, const SkipStudyOptions& options, std::vector<SkipTime>& times) {
    std::vector<std::vector<std::int64_t>> taken(times.size());
    double spent_s = 0;
    for (int round = 0; round <= options.max_rounds; ++round) {
        if (round > options.min_rounds && spent_s > options.budget_s) break;
        for (std::size_t turn = 0; turn < times.size(); ++turn) {
            // Another begins each round, so that nobody always follows the same one.
            const std::size_t i = (static_cast<std::size_t>(round) + turn) % times.size();
            const Round drawn = easel.draw(times[i].allowed);
            if (round == 0) {
                times[i].image_hash = drawn.hash;
                times[i].counts = drawn.counts;
            }
            if (drawn.hash != times.front().image_hash && times[i].status == "ok") {
                times[i].status = i == 0 ? "differs: two drawings of one scene differ"
                                         : fmt::format("differs: the image is another without {}",
                                                       harness::forbidden_skips(times[i].allowed));
            }
            if (round == 0) continue;
            for (const std::int64_t ns : drawn.draw_ns) {
                taken[i].push_back(ns);
                spent_s += static_cast<double>(ns) * 1e-9;
            }
        }
    }
    for (std::size_t i = 0; i < times.size(); ++i)
        fill_times(std::move(taken[i]), times[i]);
}

void fail(std::string_view why, std::vector<SkipTime>& times) {
    for (SkipTime& time : times)
        time.status = fmt::format("failed: {}", why);
}

/// Every scene of the study by its place in it; made one by one, for the largest take memory.
constexpr std::size_t kSceneCount = raster::kSkipCount + 3;

SkipScene nth_scene(std::size_t n, int levels) {
    if (n < raster::kSkipCount) return skip_scene(raster::skip_infos()[n].skip, levels);
    return std::move(skip_views(levels)[n - raster::kSkipCount]);
}

}  // namespace

std::vector<SkipTime> time_skips(const harness::MethodConfig& config,
                                 const SkipScene& scene,
                                 const SkipStudyOptions& options) {
    const harness::MethodConfig set = config_for(config, scene);
    SkipTime time;
    time.scene = scene.name;
    time.skip = scene.skip;
    time.method = set.info->name;
    time.params = harness::join_params(set.info->complete(set.settings));
    time.triangles = static_cast<std::int64_t>(scene::triangle_count(scene.scene));
    std::vector<SkipTime> times;
    for (const SkipArm arm : {SkipArm::on, SkipArm::one_off, SkipArm::all_off}) {
        if (arm == SkipArm::one_off && !scene.skip) continue;
        time.arm = arm;
        time.allowed = skips_of(arm, scene);
        times.push_back(time);
    }
    try {
        Easel easel(set, scene, options);
        draw_in_turns(easel, options, times);
    } catch (const std::bad_alloc&) {
        fail("out of memory", times);
    } catch (const std::exception& error) {
        fail(error.what(), times);
    }
    return times;
}

std::size_t skip_scene_count() {
    return kSceneCount;
}

std::string skip_scene_name(std::size_t n) {
    return nth_scene(n, 2).name;
}

std::vector<SkipTime> study_skip_scene(const std::vector<harness::MethodConfig>& configs,
                                       std::size_t n,
                                       const SkipStudyOptions& options) {
    std::vector<SkipTime> study;
    const SkipScene scene = nth_scene(n, options.levels);
    for (const harness::MethodConfig& config : configs) {
        if (core::is_interrupted()) break;
        std::vector<SkipTime> times = time_skips(config, scene, options);
        std::move(times.begin(), times.end(), std::back_inserter(study));
    }
    return study;
}

std::vector<std::string> skip_differences(const std::vector<SkipTime>& study) {
    std::vector<std::string> found;
    for (const SkipTime& time : study) {
        if (!time.status.starts_with("differs")) continue;
        found.push_back(fmt::format("{} on {} {}", time.method, time.scene, time.status));
    }
    return found;
}

}  // namespace ink::studies
