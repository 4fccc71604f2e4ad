#include <benchmark/benchmark.h>

#include "bench/bench_scene.h"
#include "bench/benchmarks.h"
#include "core/hash.h"
#include "methods/registry.h"

namespace ink::bench {
namespace {

/// One whole frame: everything the method does in `draw`, at its default settings.
void time_frame(benchmark::State& state,
                const methods::MethodInfo& info,
                const std::string& mesh,
                int threads) {
    const scene::Scene& scene = bench_scene(mesh);
    const auto views = bench_views(scene);
    const auto method = info.make({});
    method->prepare(scene);
    method->pose(scene);
    std::array<edge::EdgeImage, 2> out;
    out.fill(edge::EdgeImage(kWidth_px, kHeight_px));
    for (std::size_t i = 0; i < 2; ++i)
        method->draw({views[i], threads}, out[i]);
    const std::string hash = core::image_hash(out[0]);
    std::size_t frame = 0;
    for (auto _ : state) {
        method->draw({views[frame % 2], threads}, out[frame % 2]);
        ++frame;
    }
    if (core::image_hash(out[0]) != hash) state.SkipWithError("the frame changed when drawn again");
    state.SetLabel(hash);
    state.counters["triangles"] = static_cast<double>(scene::triangle_count(scene));
    state.counters["bytes_per_px"] = method->bytes_per_px();
}

}  // namespace

void add_frame_benchmarks() {
    for (const std::string& mesh : mesh_names()) {
        for (const methods::MethodInfo& info : methods::registry()) {
            for (const int threads : {1, 2}) {
                const std::string name =
                    "frame/" + info.name + "/" + mesh + "/1080p/threads:" + std::to_string(threads);
                benchmark::RegisterBenchmark(name.c_str(),
                                             [&info, mesh, threads](benchmark::State& state) {
                                                 time_frame(state, info, mesh, threads);
                                             })
                    ->Unit(benchmark::kMillisecond);
            }
        }
    }
}

}  // namespace ink::bench
