#include <algorithm>
#include <array>
#include <cmath>

#include "core/simd.h"
#include "studies/stress/stress_cases.h"

namespace ink::studies {
namespace {

/// How a method writes depth, and what the depth test stores.
struct DepthChoice {
    const char* encoding;
    const char* test;
};

constexpr std::array<DepthChoice, 10> kDepths = {{{"inverse", "q32"},
                                                  {"reversed_float", "q32"},
                                                  {"zbuffer24", "q32"},
                                                  {"zbuffer16", "q32"},
                                                  {"log", "q32"},
                                                  {"linear", "q32"},
                                                  {"inverse", "z24"},
                                                  {"zbuffer24", "z24"},
                                                  {"inverse", "z16"},
                                                  {"zbuffer16", "z16"}}};

// Of a camera that need not know its scene, as games have it.
constexpr double kFarOverNear = 1e5;

// Every target by itself and in company.
constexpr std::array<int, 2> kSimdThreads = {1, 4};

std::size_t place_of(const StressPoint& point) {
    return static_cast<std::size_t>(std::lround(point.value)) - 1;
}

std::vector<Case> with_gain(const StressPoint& point, const char* overflow) {
    std::vector<Case> cases = base_cases(point);
    for (Case& stress : cases) {
        stress.code_gain = point.value;
        stress.settings = {std::string("overflow=") + overflow};
    }
    return cases;
}

}  // namespace

std::vector<std::string> depth_names() {
    std::vector<std::string> names;
    for (const DepthChoice& depth : kDepths)
        names.push_back(std::string(depth.encoding) + " " + depth.test);
    return names;
}

std::vector<Case> depth_cases(const StressPoint& point) {
    const DepthChoice& depth = kDepths.at(place_of(point));
    std::vector<Case> cases = catalogue_cases(point, {"room", "horizon", "staircase", "fence"});
    for (Case& stress : cases) {
        scene::Camera& camera = stress.scene_views.views.front().camera;
        camera.near = std::min(camera.near, camera.far / kFarOverNear);
        stress.settings = {"depth_range=camera",
                           std::string("depth_encoding=") + depth.encoding,
                           std::string("depth_format=") + depth.test};
    }
    return cases;
}

std::vector<Case> code_bits_cases(const StressPoint& point) {
    std::vector<Case> cases = base_cases(point);
    for (Case& stress : cases)
        stress.code_bits = static_cast<int>(std::lround(point.value));
    return cases;
}

std::vector<Case> saturate_cases(const StressPoint& point) {
    return with_gain(point, "saturate");
}

std::vector<Case> wrap_cases(const StressPoint& point) {
    return with_gain(point, "wrap");
}

std::vector<Case> thread_cases(const StressPoint& point) {
    std::vector<Case> cases = base_cases(point);
    for (Case& stress : cases)
        stress.threads = static_cast<int>(std::lround(point.value));
    return cases;
}

std::vector<std::string> simd_names() {
    std::vector<std::string> names;
    for (const core::SimdTarget& target : core::simd_targets()) {
        for (const int threads : kSimdThreads)
            names.push_back(target.name + " x " + std::to_string(threads));
    }
    return names;
}

std::vector<Case> simd_cases(const StressPoint& point) {
    std::vector<Case> cases = base_cases(point);
    const std::size_t place = place_of(point);
    for (Case& stress : cases) {
        stress.simd_target = core::simd_targets().at(place / kSimdThreads.size()).name;
        stress.threads = kSimdThreads[place % kSimdThreads.size()];
    }
    return cases;
}

}  // namespace ink::studies
