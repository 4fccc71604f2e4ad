#include <benchmark/benchmark.h>

#include <string>

#include "bench/bench_scene.h"
#include "bench/benchmarks.h"
#include "bench/ray_tree.h"
#include "core/hash.h"
#include "core/image.h"

namespace ink::bench {
namespace {

static_assert(kWidth_px % kPacketSide == 0 && kHeight_px % kPacketSide == 0);

/// The triangle at every pixel centre: what a frame of ray tracing costs before it shades anything.
/// The tree is made beforehand and not timed.
void time_primary(benchmark::State& state, const std::string& mesh) {
    const scene::Scene& scene = bench_scene(mesh);
    const RayTree tree(scene, bench_views(scene)[0]);
    core::Image<std::uint32_t> ids(kWidth_px, kHeight_px);
    for (auto _ : state) {
        for (int y = 0; y < kHeight_px; y += kPacketSide) {
            for (int x = 0; x < kWidth_px; x += kPacketSide) {
                const PacketIds packet = tree.cast(x + 0.5, y + 0.5, 1);
                for (int i = 0; i < kPacket; ++i)
                    ids.at(x + i % kPacketSide, y + i / kPacketSide) =
                        packet[static_cast<std::size_t>(i)];
            }
        }
        benchmark::ClobberMemory();
    }
    state.SetLabel(core::image_hash(ids));
    state.counters["triangles"] = static_cast<double>(scene::triangle_count(scene));
    state.counters["rays"] = static_cast<double>(ids.size());
}

}  // namespace

void add_embree_benchmarks() {
    for (const std::string& mesh : mesh_names())
        add("embree/primary/" + mesh + "/1080p/threads:1", time_primary, mesh);
}

}  // namespace ink::bench
