#include <benchmark/benchmark.h>

#include "bench/bench_scene.h"
#include "bench/benchmarks.h"
#include "core/hash.h"
#include "truth/truth.h"

namespace ink::bench {
namespace {

/// The whole truth of a view, from the scene: topology, Embree's tree, lines, visibility, layers.
void time_truth(benchmark::State& state, const std::string& mesh) {
    const scene::Scene& scene = bench_scene(mesh);
    const scene::View view = bench_views(scene)[0];
    truth::Truth truth;
    for (auto _ : state)
        truth = truth::trace_truth(scene, view, {});
    state.SetLabel(core::image_hash(truth.labels));
    state.counters["rays"] = static_cast<double>(truth.counts.rays);
    state.counters["samples"] = static_cast<double>(truth.counts.samples);
}

}  // namespace

void add_truth_benchmarks() {
    for (const std::string& mesh : mesh_names()) {
        const std::string name = "truth/" + mesh + "/1080p";
        benchmark::RegisterBenchmark(name.c_str(), [mesh](benchmark::State& state) {
            time_truth(state, mesh);
        })->Unit(benchmark::kMillisecond);
    }
}

}  // namespace ink::bench
