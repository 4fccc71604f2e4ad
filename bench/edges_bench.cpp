#include <benchmark/benchmark.h>

#include <array>

#include "bench/benchmarks.h"
#include "core/hash.h"
#include "methods/edge_hash/soup_models.h"

namespace ink::bench {
namespace {

/// Two frames of an animation of a sphere.
std::array<scene::Scene, 2> make_frames() {
    std::array<scene::Scene, 2> frames;
    frames.fill(bench_scene("sphere"));
    for (glm::vec3& p : frames[1].meshes[0].positions)
        p.y *= 1.25F;
    return frames;
}

/// What TechnicalQuake's cache saves: a new frame of a model, or one that was there before.
void time_frames(benchmark::State& state, std::size_t most_frames) {
    const auto frames = make_frames();
    methods::SoupModels models(
        {.epsilon = 1e-5, .most_frames = most_frames, .crease_rad = 0.6981317007977318});
    models.prepare(frames[0]);
    for (const scene::Scene& frame : frames)
        models.pose(frame);
    std::size_t i = 0;
    for (auto _ : state)
        models.pose(frames[i++ % 2]);
    models.pose(frames[0]);
    const auto lines = models.lines({{3, 2, 4}});
    state.SetLabel(core::Hasher().value(lines.size()).hex());
    state.counters["lines"] = static_cast<double>(lines.size());
}

}  // namespace

void add_edge_benchmarks() {
    // With room for one frame each pose is a first one.
    add("edge_hash/first/sphere", time_frames, std::size_t{1});
    add("edge_hash/cached/sphere", time_frames, std::size_t{2});
}

}  // namespace ink::bench
