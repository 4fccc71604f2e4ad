#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

/// An axis of named values: 1, 2, 3 and so on.
Axis named_axis(StressHeading heading,
                std::vector<std::string> names,
                std::string sentence,
                StressMaker make) {
    heading.scale = AxisScale::named;
    Axis axis = make_axis(std::move(heading),
                          evenly(1, static_cast<double>(names.size()), 1),
                          std::move(sentence),
                          std::move(make));
    axis.value_names = std::move(names);
    return axis;
}

std::size_t place_of(const StressPoint& point) {
    return static_cast<std::size_t>(std::lround(point.value)) - 1;
}

StressMaker with_gain(const std::string& overflow) {
    return changed(base_cases(), [overflow](const StressPoint& point, Case& stress) {
        stress.code_gain = point.value;
        stress.settings = {"overflow=" + overflow};
    });
}

std::vector<std::string> depth_names() {
    std::vector<std::string> names;
    for (const DepthChoice& depth : kDepths)
        names.push_back(std::string(depth.encoding) + " " + depth.test);
    return names;
}

void set_depth(const StressPoint& point, Case& stress) {
    const DepthChoice& depth = kDepths.at(place_of(point));
    scene::Camera& camera = stress.scene_views.views.front().camera;
    camera.near = std::min(camera.near, camera.far / kFarOverNear);
    stress.settings = {"depth_range=camera",
                       std::string("depth_encoding=") + depth.encoding,
                       std::string("depth_format=") + depth.test};
}

/// Of this machine's targets, each on one thread and on four.
std::vector<std::string> simd_names() {
    std::vector<std::string> names;
    for (const core::SimdTarget& target : core::simd_targets()) {
        for (const int threads : kSimdThreads)
            names.push_back(target.name + " x " + std::to_string(threads));
    }
    return names;
}

void set_simd(const StressPoint& point, Case& stress) {
    const std::size_t place = place_of(point);
    stress.simd_target = core::simd_targets().at(place / kSimdThreads.size()).name;
    stress.threads = kSimdThreads[place % kSimdThreads.size()];
}

}  // namespace

void add_parameter_axes(std::vector<Axis>& axes) {
    axes.push_back(named_axis(
        {"depth", "encoding of depth, format of the depth test"},
        depth_names(),
        "How a method writes depth (depth_encoding) and what the depth test stores "
        "(depth_format): q32 is a float of 1/w, z24 and z16 are whole steps; on scenes of great "
        "depth, far 1e5 times as far as near, and depth scaled to these (depth_range = camera). A "
        "method without a parameter keeps its own.",
        changed(catalogue_cases({"room", "horizon", "staircase", "fence"}), set_depth)));
    axes.push_back(make_axis(
        {"code_bits", "bits of the packed code", "bits", AxisScale::linear},
        evenly(3, 16, 1),
        "Ranges of packed codes shrink by powers of two and the response is scaled up by as many "
        "bits. The 16 fractional bits of the rasterizer's code planes are a constant; this axis "
        "varies the whole bits. Methods that pack nothing do not change.",
        changed(base_cases(), [](const StressPoint& point, Case& stress) {
            stress.code_bits = static_cast<int>(std::lround(point.value));
        })));
    axes.push_back(make_axis(
        {"saturate", "sum of the ranges over what they are by default"},
        {0.25, 0.35, 0.5, 0.71, 1, 1.41, 2, 2.83, 4},
        "All ranges of packed codes and their threshold times a factor, as far as the parameters "
        "reach; beyond 1 codes overflow by intent and saturate.",
        with_gain("saturate")));
    axes.push_back(make_axis({"wrap", "sum of the ranges over what they are by default"},
                             {0.25, 0.35, 0.5, 0.71, 1, 1.41, 2, 2.83, 4},
                             "The same, but codes wrap and are filtered modulo their range.",
                             with_gain("wrap")));
    axes.push_back(make_axis({"threads", "threads", "", AxisScale::linear},
                             evenly(1, 8, 1),
                             "The same images by 1 to 8 threads.",
                             changed(base_cases(), [](const StressPoint& point, Case& stress) {
                                 stress.threads = static_cast<int>(std::lround(point.value));
                             })));
    axes.back().same_images = true;
    axes.push_back(named_axis(
        {"simd", "instruction set x threads"},
        simd_names(),
        "The same images by every instruction set that the kernels were compiled for and this "
        "machine runs, each on one thread and on four; the points depend on the machine.",
        changed(base_cases(), set_simd)));
    axes.back().same_images = true;
}

}  // namespace ink::studies
