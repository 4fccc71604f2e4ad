#pragma once

#include <random>

#include "tests/methods/small_scenes.h"

// The law of skips: whatever a method is allowed to skip, its image is the one it draws when it
// may skip nothing. As functions that name the first breach.

namespace ink::methods {

using MakeMethod = std::function<std::unique_ptr<method::Method>()>;

/// What is allowed, and what to call it.
struct NamedSkips {
    std::string name;
    raster::SkipSet skips;
};

/// Everything, nothing, everything but one, nothing but one.
inline std::vector<NamedSkips> skip_sets() {
    std::vector<NamedSkips> sets = {{"all on", {}}, {"all off", raster::SkipSet::none()}};
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        sets.push_back({std::string(info.name) + " off", raster::SkipSet().set(info.skip, false)});
        sets.push_back({"only " + std::string(info.name) + " on",
                        raster::SkipSet::none().set(info.skip, true)});
    }
    return sets;
}

/// What a new method, prepared at the `start`, draws of one frame when it may skip nothing.
inline edge::EdgeImage drawn_scalar(const MakeMethod& make,
                                    const scene::Scene& start,
                                    const scene::Scene& scene,
                                    const scene::View& view) {
    const auto method = make();
    method->prepare(start);
    method->pose(scene);
    return image_by(*method, {view, 1, raster::SkipSet::none()});
}

/// The first set of skips that changes an image of a scene that stands still, "" if none does.
///
/// `views` are at least two that differ: drawn in turns, no frame is like the one before it, so
/// that no tile can be taken from there.
inline std::string breach_of_a_view(const MakeMethod& make,
                                    const scene::Scene& scene,
                                    const std::vector<scene::View>& views) {
    std::vector<edge::EdgeImage> expected;
    for (const scene::View& view : views)
        expected.push_back(drawn_scalar(make, scene, scene, view));
    const auto method = make();
    method->prepare(scene);
    method->pose(scene);
    int threads = 1;
    for (const NamedSkips& set : skip_sets()) {
        for (std::size_t i = 0; i < views.size(); ++i) {
            if (image_by(*method, {views[i], threads, set.skips}) != expected[i]) {
                return set.name + ", " + views[i].camera.name + ", " + std::to_string(threads) +
                       " threads";
            }
            threads = 3 - threads;
        }
        if (views.size() % 2 == 0) threads = 3 - threads;
    }
    return "";
}

/// A frame of a sequence: what changed since the one before it.
struct Step {
    std::string name;
    scene::Scene scene;
    scene::View view;
    bool is_posed = true;  ///< `pose` is called before it
    int threads = 1;
};

/// The first frame that one method, drawing all of them, draws otherwise than a new one that may
/// skip nothing; "" if none. `skips_of` says what is allowed in frame i.
inline std::string breach_of_a_sequence(
    const MakeMethod& make,
    const std::vector<Step>& steps,
    const std::vector<edge::EdgeImage>& expected,
    const std::function<raster::SkipSet(std::size_t)>& skips_of) {
    const auto method = make();
    method->prepare(steps.front().scene);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const Step& step = steps[i];
        if (step.is_posed) method->pose(step.scene);
        if (image_by(*method, {step.view, step.threads, skips_of(i)}) != expected[i])
            return step.name;
    }
    return "";
}

/// What new methods that may skip nothing draw of each step. While an animation goes on, codes are
/// those of its first step.
inline std::vector<edge::EdgeImage> expected_of(const MakeMethod& make,
                                                const std::vector<Step>& steps) {
    std::vector<edge::EdgeImage> expected;
    for (const Step& step : steps) {
        const scene::Scene& start = step.scene.animation ? steps.front().scene : step.scene;
        expected.push_back(drawn_scalar(make, start, step.scene, step.view));
    }
    return expected;
}

/// Sets of skips drawn by lot, another for every frame: what one frame leaves behind must not
/// mislead one that is allowed something else.
inline std::function<raster::SkipSet(std::size_t)> changing_skips(unsigned seed) {
    return [seed](std::size_t frame) {
        std::mt19937 random(1000 * seed + static_cast<unsigned>(frame));
        raster::SkipSet skips;
        for (const raster::SkipInfo& info : raster::skip_infos())
            skips.set(info.skip, random() % 4 != 0);
        return skips;
    };
}

}  // namespace ink::methods
