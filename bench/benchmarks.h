#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

/// One function per room: it registers the room's benchmarks under the names that scripts look for.
///
/// Explicit, like the registry of methods; main.cpp calls them in the order in which tables show
/// them. Every benchmark checks its result before it is timed where there is something to check it
/// against, and carries a hash of it as its label: a run whose repetitions differ there fails.
namespace ink::bench {

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
