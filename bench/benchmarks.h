#pragma once

#include <benchmark/benchmark.h>
#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/surface.h"

/// One function per room: it registers the room's benchmarks under the names that scripts look for.
///
/// Explicit, like the registry of methods; main.cpp calls them in the order in which tables show
/// them. Every benchmark checks its result before it is timed where there is something to check it
/// against, and carries a hash of it as its label: a run whose repetitions differ there fails.

namespace ink::bench {

inline constexpr int kWidth_px = 1920;
inline constexpr int kHeight_px = 1080;

/// The meshes that everything is timed on: `sphere` (made here, 69 thousand triangles), and where
/// the files are in inkbench-out/models `dragon_coarse` (47 thousand) and `dragon` (871 thousand).
[[nodiscard]] std::vector<std::string> mesh_names();

/// The mesh called `name` as a scene of one instance; made at its first use and kept.
[[nodiscard]] const scene::Scene& bench_scene(const std::string& name);

/// The same as methods lay it out by default: shared corners, normals over patches at 40 degrees.
/// Made at its first use and kept.
[[nodiscard]] const scene::Surface& bench_surface(const std::string& name);

/// Two views a degree apart that the mesh fills from top to bottom. Benchmarks draw them in turns,
/// so that nothing is free because the last frame was the same.
[[nodiscard]] std::array<scene::View, 2> bench_views(const scene::Scene& scene);

/// Gives the calling thread one core and the workers of oneTBB another, so that `threads:1` is
/// timed on one core and `threads:2` on two without `taskset`. Call it first in main.
///
/// Takes the last of the cores that the process was given, and for the workers the last that is not
/// the same core's other hardware thread; threads made later inherit from the one that makes them.
/// Where that cannot be had (one core only, a refusal) it says so on stderr and goes on.
void pin_to_cores();

void add_filter_benchmarks();
/// Passes and frames are run exactly `draws` times a repetition; 0 lets the library choose.
void add_raster_benchmarks(int draws);
void add_frame_benchmarks(int draws);
/// What a cache of edges saves.
void add_edge_benchmarks();
void add_embree_benchmarks();
void add_truth_benchmarks();
void add_score_benchmarks();

/// Adds a benchmark that calls time(state, args...).
template <class Time, class... Args>
benchmark::internal::Benchmark* add(const std::string& name, Time time, const Args&... args) {
    const auto least = [](const std::vector<double>& times) { return std::ranges::min(times); };
    return benchmark::RegisterBenchmark(name.c_str(), time, args...)
        ->ComputeStatistics("min", least)
        ->Unit(benchmark::kMicrosecond);
}

/// Adds `name/threads:1` and `name/threads:2`, which call time(state, key, threads); `draws` as
/// above.
template <class Key>
void add_with_threads(const std::string& name,
                      int draws,
                      void (*time)(benchmark::State&, const Key&, int),
                      const Key& key) {
    for (const int threads : {1, 2}) {
        auto* added = add(name + "/threads:" + std::to_string(threads), time, key, threads);
        if (draws > 0) added->Iterations(draws);
    }
}

}  // namespace ink::bench
