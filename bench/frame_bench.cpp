#include <benchmark/benchmark.h>

#include <map>
#include <utility>

#include "bench/benchmarks.h"
#include "core/hash.h"
#include "methods/registry.h"

namespace ink::bench {
namespace {

/// One method at its default settings on one mesh.
struct FrameKey {
    const method::MethodInfo& info;
    std::string mesh;
};

/// Prepared and posed once for all threads and repetitions: `draw` is what is timed.
method::Method& prepared(const FrameKey& key) {
    static std::map<std::pair<std::string, std::string>, std::unique_ptr<method::Method>> kept;
    auto& method = kept[{key.info.name, key.mesh}];
    if (method == nullptr) {
        method = key.info.make({});
        method->prepare(bench_scene(key.mesh));
        method->pose(bench_scene(key.mesh));
    }
    return *method;
}

/// One whole frame: everything the method does in `draw`. The two views come in turns.
void time_frame(benchmark::State& state, const FrameKey& key, int threads) {
    const scene::Scene& scene = bench_scene(key.mesh);
    const auto views = bench_views(scene);
    method::Method& method = prepared(key);
    std::array<edge::EdgeImage, 2> out;
    out.fill(edge::EdgeImage(kWidth_px, kHeight_px));
    const auto hash_of_both = [&] {
        return core::Hasher().text(core::image_hash(out[0])).text(core::image_hash(out[1])).hex();
    };
    for (std::size_t i = 0; i < 2; ++i)
        method.draw({views[i], threads}, out[i]);
    const std::string hash = hash_of_both();
    std::size_t frame = 0;
    for (auto _ : state) {
        method.draw({views[frame % 2], threads}, out[frame % 2]);
        ++frame;
    }
    if (hash_of_both() != hash) state.SkipWithError("the frame changed when drawn again");
    state.SetLabel(hash);
    state.counters["triangles"] = static_cast<double>(scene::triangle_count(scene));
    state.counters["vertices"] = static_cast<double>(bench_surface(key.mesh).p_world.size());
    state.counters["bytes_per_px"] = method.bytes_per_px();
}

}  // namespace

void add_frame_benchmarks(int draws) {
    for (const std::string& mesh : mesh_names()) {
        for (const method::MethodInfo& info : methods::registry())
            add_with_threads(
                "frame/" + info.name + "/" + mesh + "/1080p", draws, time_frame, {info, mesh});
    }
}

}  // namespace ink::bench
