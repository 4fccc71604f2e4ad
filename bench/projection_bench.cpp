#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <queue>
#include <string>
#include <vector>

#include "bench/bench_scene.h"
#include "bench/benchmarks.h"
#include "bench/limit_parts.h"
#include "core/hash.h"
#include "core/parallel.h"
#include "raster/mesh/mesh_stage.h"
#include "raster/mesh/mesh_tiles.h"

namespace ink::bench {
namespace {

double now_ns() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return static_cast<double>(std::chrono::nanoseconds(now).count());
}

template <class Work>
double time_of_ns(const Work& work) {
    const double begin_ns = now_ns();
    work();
    return now_ns() - begin_ns;
}

/// How long `cores` take for units of work of which each takes the next as soon as it is free.
double makespan_ns(const std::vector<double>& units_ns, int cores) {
    std::priority_queue<double, std::vector<double>, std::greater<>> free_at_ns;
    for (int core = 0; core < cores; ++core)
        free_at_ns.push(0);
    double end_ns = 0;
    for (const double unit_ns : units_ns) {
        const double done_ns = free_at_ns.top() + unit_ns;
        free_at_ns.pop();
        free_at_ns.push(done_ns);
        end_ns = std::max(end_ns, done_ns);
    }
    return end_ns;
}

/// The least time in which two threads are woken and waited for: what any number is taken to cost.
double wake_ns() {
    static const double kWake_ns = [] {
        double least_ns = 1e9;
        for (int i = 0; i < 200; ++i)
            least_ns = std::min(least_ns,
                                time_of_ns([] { core::parallel_for(2, 2, [](std::size_t) {}); }));
        return least_ns;
    }();
    return kWake_ns;
}

/// A frame on more cores than there are: MeshPass::draw with its work divided as on so many
/// threads, every unit of it done on one and timed. What cores take from each other (memory, the
/// last cache, clock) is not in it.
class ProjectedFrame {
  public:
    ProjectedFrame(const std::string& mesh, int cores)
        : cores_(cores), view_(limit_view(bench_scene(mesh))), value_(view_) {
        input_ = limit_input(mesh, view_);
        format_.interpolants = 1;
        input_.values = &value_;
        grid_ = {view_.width_px, view_.height_px, format_.halo_px};
        out_ = edge::EdgeImage(view_.width_px, view_.height_px);
    }
    ProjectedFrame(const ProjectedFrame&) = delete;  // its job borrows from it
    ProjectedFrame& operator=(const ProjectedFrame&) = delete;

    /// The hash of the frame that MeshPass itself draws.
    [[nodiscard]] std::string expected_hash() {
        LimitSink sink(true, out_);
        (void)raster::MeshPass().draw(format_, input_, sink);
        return hash();
    }

    /// The time of a frame on that many cores.
    double draw_ns() {
        const double order_ns = time_of_ns([&] { make_order(); });
        const raster::MeshJob& job = *job_;
        const std::size_t clusters = job.order.clusters.size();
        const std::size_t nearest = raster::front_clusters(format_, input_, grid_, job.solids);
        const std::size_t fronts = nearest == 0 ? 0 : raster::run_count(nearest, cores_);
        const std::size_t others = raster::run_count(clusters - nearest, cores_);
        runs_.resize(fronts + others);
        double total_ns = divided_order_ns(order_ns, clusters);
        LimitSink sink(true, out_);
        if (fronts > 0) {
            total_ns += time_of_ns([&] { front_.start(grid_, input_); });
            total_ns += process_ns(0, nearest, 0, fronts);
            total_ns += tiles_ns(
                fronts, [](raster::MeshTileWorker& worker, int tile) { worker.draw_front(tile); });
        }
        total_ns += process_ns(nearest, clusters, fronts, others);
        total_ns += tiles_ns(
            fronts, [&](raster::MeshTileWorker& worker, int tile) { worker.draw(tile, sink); });
        return total_ns;
    }

    [[nodiscard]] std::string hash() const { return core::image_hash(out_); }

  private:
    void make_order() {
        const auto solids = raster::view_solids(input_);
        job_ =
            std::make_unique<raster::MeshJob>(raster::MeshJob{format_,
                                                              input_,
                                                              grid_,
                                                              raster::ViewTransform(view_),
                                                              solids,
                                                              raster::front_to_back(input_, solids),
                                                              true,
                                                              {}});
    }

    /// The order is made in three loops over slices.
    [[nodiscard]] double divided_order_ns(double one_ns, std::size_t clusters) const {
        const std::size_t slices = raster::slice_count(clusters, cores_);
        return slices == 1 ? one_ns : one_ns / static_cast<double>(slices) + 3 * wake_ns();
    }

    double process_ns(std::size_t first, std::size_t end, std::size_t run, std::size_t count) {
        std::vector<double> units_ns;
        for (std::size_t i = 0; i < count; ++i) {
            units_ns.push_back(time_of_ns([&] {
                runs_[run + i].process(*job_,
                                       first + i * (end - first) / count,
                                       first + (i + 1) * (end - first) / count,
                                       first == 0 ? nullptr : &front_);
            }));
        }
        return makespan_ns(units_ns, cores_) + woken_ns();
    }

    template <class Visit>
    double tiles_ns(std::size_t fronts, const Visit& visit) {
        std::unique_ptr<raster::MeshTileWorker> worker;
        const double start_ns = time_of_ns([&] {
            worker = std::make_unique<raster::MeshTileWorker>(*job_, runs_, fronts, front_);
        });
        std::vector<double> units_ns;
        for (int tile = 0; tile < grid_.count(); ++tile)
            units_ns.push_back(time_of_ns([&] { visit(*worker, tile); }));
        return start_ns + makespan_ns(units_ns, cores_) + woken_ns();
    }

    [[nodiscard]] double woken_ns() const { return cores_ == 1 ? 0 : wake_ns(); }

    int cores_;
    scene::View view_;
    SmoothValue value_;
    raster::PassFormat format_ = limit_format();
    raster::MeshInput input_;
    raster::TileGrid grid_;
    edge::EdgeImage out_;
    std::unique_ptr<raster::MeshJob> job_;
    std::vector<raster::MeshRun> runs_;
    raster::FrontDepth front_;
};

void time_projection(benchmark::State& state, const std::string& mesh, int cores) {
    ProjectedFrame frame(mesh, cores);
    const std::string expected = frame.expected_hash();
    frame.draw_ns();
    if (frame.hash() != expected) return state.SkipWithError("another image than the pass draws");
    for (auto _ : state)
        state.SetIterationTime(1e-9 * frame.draw_ns());
    state.SetLabel(frame.hash());
    state.counters["wake_us"] = 1e-3 * wake_ns();
    state.counters["triangles"] = static_cast<double>(scene::triangle_count(bench_scene(mesh)));
}

}  // namespace

void add_projection_benchmarks(const std::vector<std::string>& meshes) {
    for (const std::string& mesh : meshes) {
        for (const int cores : {1, 2, 4, 8, 16}) {
            const std::string name = "projected/" + mesh + "/cores:" + std::to_string(cores);
            benchmark::RegisterBenchmark(
                name.c_str(),
                [mesh, cores](benchmark::State& state) { time_projection(state, mesh, cores); })
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
    }
}

}  // namespace ink::bench
