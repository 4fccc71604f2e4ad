#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/bench_scene.h"
#include "bench/benchmarks.h"
#include "bench/limit_parts.h"
#include "core/hash.h"
#include "methods/registry.h"
#include "raster/mesh/mesh_pass.h"
#include "raster/mesh/mesh_stage.h"

namespace ink::bench {
namespace {

/// How far a frame is taken; each stage has those before it in it.
enum class Stage {
    cull,       ///< order of clusters; those outside or turned away are found
    transform,  ///< and the vertices of the others are put on the screen, with their values
    lists,      ///< and their triangles are sorted out and listed per tile
    setup,      ///< and everything that is listed is set up, hidden or not
    fill,       ///< a whole pass
    edges,      ///< and the filter: a frame
};
constexpr std::array<std::pair<Stage, const char*>, 6> kStages = {{{Stage::cull, "cull"},
                                                                   {Stage::transform, "transform"},
                                                                   {Stage::lists, "lists"},
                                                                   {Stage::setup, "setup"},
                                                                   {Stage::fill, "fill"},
                                                                   {Stage::edges, "edges"}}};

struct LimitKey {
    std::string mesh;
    bool has_backs = true;  ///< what is seen from its back is drawn, too, where it may be seen
    bool is_smooth = true;  ///< a value that runs across triangles; else one a triangle
    Stage stage = Stage::edges;
};

/// A frame of a key, and what is kept for it.
class LimitFrame {
  public:
    explicit LimitFrame(const LimitKey& key)
        : key_(key), view_(limit_view(bench_scene(key.mesh))), value_(view_) {
        format_.interpolants = key.is_smooth ? 1 : 0;
        format_.constant = !key.is_smooth;
        input_.cull = key.has_backs ? raster::Cull::none : raster::Cull::back;
        if (key.is_smooth) {
            input_.values = &value_;
        } else {
            const std::size_t count = input_.mesh->surface().triangles.size();
            for (std::size_t t = 0; t < count; ++t)
                constants_.push_back(1 + static_cast<std::uint32_t>(t * 2654435761U >> 8) % 255);
            for (const std::uint32_t id : input_.mesh->clusters().triangle_ids)
                in_clusters_.push_back(static_cast<std::uint8_t>(constants_[id]));
            input_.constants = constants_;
            input_.constants_in_clusters = in_clusters_;
        }
        out_ = edge::EdgeImage(view_.width_px, view_.height_px);
    }
    LimitFrame(const LimitFrame&) = delete;
    LimitFrame& operator=(const LimitFrame&) = delete;

    void draw() {
        if (key_.stage >= Stage::fill) {
            LimitSink sink(key_.stage == Stage::edges, out_);
            skips_ = pass_.draw(format_, input_, sink).skips;
            return;
        }
        const raster::TileGrid grid{view_.width_px, view_.height_px, format_.halo_px};
        const auto solids = raster::view_solids(input_);
        const raster::MeshJob job{format_,
                                  input_,
                                  grid,
                                  raster::ViewTransform(view_),
                                  solids,
                                  raster::front_to_back(input_, solids),
                                  true,
                                  {}};
        if (key_.stage <= Stage::transform) return project(job);
        run_.process(job, 0, job.order.clusters.size());
        if (key_.stage == Stage::setup) set_up(job);
    }

    /// Of a whole pass: triangles in lists of tiles or in clusters that were looked at, and those
    /// of them that were found hidden.
    [[nodiscard]] raster::SkipCount hidden() const {
        return skips_[static_cast<std::size_t>(raster::Skip::occlusion_culling)];
    }
    [[nodiscard]] std::string hash() const { return core::image_hash(out_); }

  private:
    void project(const raster::MeshJob& job) {
        const raster::LaneMesh& mesh = *input_.mesh;
        const raster::ImageSides sides(job.transform, view_);
        std::vector<std::uint32_t> seen;
        for (const std::uint32_t index : job.order.clusters) {
            const scene::Cluster& cluster = mesh.clusters().clusters[index];
            if (sides.has_outside(cluster.bounds)) continue;
            const bool drops = job.drops_backs(job.hides_backs(index));
            if (drops && scene::is_turned_away(cluster, view_.camera.eye_world)) continue;
            seen.push_back(index);
        }
        benchmark::DoNotOptimize(seen.data());
        if (key_.stage == Stage::cull) return;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            for (std::size_t part = 0; part < raster::LaneMesh::kPrefetchParts; ++part) {
                if (i + 1 < seen.size()) mesh.prefetch(seen[i + 1], part);
            }
            const std::size_t stride =
                raster::lane_padded(mesh.clusters().clusters[seen[i]].vertex_count);
            lanes_.records = {reinterpret_cast<std::byte*>(records_.data()), stride};
            (void)raster::project_cluster(mesh, seen[i], job.transform, view_.camera.near, lanes_);
            if (!key_.is_smooth) continue;
            raster::CornerPlanes planes;
            planes.front[0] = lanes_.records.array(3);
            value_.compute(lanes_.batch(mesh, seen[i]), planes);
        }
        benchmark::DoNotOptimize(records_.data());
    }

    void set_up(const raster::MeshJob& job) {
        constexpr std::size_t kMost = raster::LaneTriangles::kCount;
        for (int tile = 0; tile < job.grid.count(); ++tile) {
            entries_.clear();
            for (const std::uint32_t entry : run_.of(tile)) {
                if (!raster::is_scalar(entry) && !raster::is_fragments(entry))
                    entries_.push_back(entry);
            }
            for (std::size_t at = 0; at < entries_.size(); at += kMost) {
                const std::size_t count = std::min(kMost, entries_.size() - at);
                raster::set_up_lanes(format_,
                                     run_.source(),
                                     {entries_.data() + at, count},
                                     job.grid.drawn(tile),
                                     {},
                                     triangles_);
                benchmark::DoNotOptimize(triangles_);
            }
        }
    }

    LimitKey key_;
    scene::View view_;
    SmoothValue value_;
    raster::PassFormat format_ = limit_format();
    raster::MeshInput input_ = limit_input(key_.mesh, view_);
    std::vector<std::uint32_t> constants_;
    std::vector<std::uint8_t> in_clusters_;
    edge::EdgeImage out_;
    raster::MeshPass pass_;
    raster::SkipCounts skips_{};
    raster::MeshRun run_;
    raster::ClusterLanes lanes_;
    raster::AlignedArray<float> records_ = [] {
        raster::AlignedArray<float> records;
        records.resize(raster::LaneRecords::kMostArrays * scene::kMaxClusterVertices);
        return records;
    }();
    std::vector<std::uint32_t> entries_;
    raster::LaneTriangles triangles_;
};

void time_limit(benchmark::State& state, const LimitKey& key) {
    const auto frame = std::make_unique<LimitFrame>(key);
    frame->draw();
    for (auto _ : state)
        frame->draw();
    state.SetLabel(frame->hash());
    state.counters["listed"] = static_cast<double>(frame->hidden().of);
    state.counters["hidden"] = static_cast<double>(frame->hidden().skipped);
    state.counters["triangles"] = static_cast<double>(scene::triangle_count(bench_scene(key.mesh)));
}

/// A method's whole frame from the same place.
void time_method(benchmark::State& state,
                 const method::MethodInfo& info,
                 const std::string& mesh,
                 int threads) {
    static std::map<std::pair<std::string, std::string>, std::unique_ptr<method::Method>> kept;
    auto& method = kept[{info.name, mesh}];
    const scene::Scene& scene = bench_scene(mesh);
    if (method == nullptr) {
        method = info.make({});
        method->prepare(scene);
        method->pose(scene);
    }
    const scene::View view = limit_view(scene);
    edge::EdgeImage out(view.width_px, view.height_px);
    method->draw({view, threads}, out);
    for (auto _ : state)
        method->draw({view, threads}, out);
    state.SetLabel(core::image_hash(out));
    state.counters["triangles"] = static_cast<double>(scene::triangle_count(scene));
}

}  // namespace

void add_limit_benchmarks(const std::vector<std::string>& meshes) {
    for (const std::string& mesh : meshes) {
        for (const bool has_backs : {true, false}) {
            for (const bool is_smooth : {true, false}) {
                for (const auto& [stage, stage_name] : kStages) {
                    const LimitKey key{mesh, has_backs, is_smooth, stage};
                    const std::string name = std::string("limit/") + stage_name +
                                             (has_backs ? "/both" : "/front") +
                                             (is_smooth ? "/smooth/" : "/flat/") + mesh;
                    benchmark::RegisterBenchmark(name.c_str(), [key](benchmark::State& state) {
                        time_limit(state, key);
                    })->Unit(benchmark::kMillisecond);
                }
            }
        }
        for (const method::MethodInfo& info : methods::registry()) {
            for (const int threads : {1, 2}) {
                const std::string name =
                    "limit/" + info.name + "/" + mesh + "/threads:" + std::to_string(threads);
                benchmark::RegisterBenchmark(name.c_str(),
                                             [info, mesh, threads](benchmark::State& state) {
                                                 time_method(state, info, mesh, threads);
                                             })
                    ->Unit(benchmark::kMillisecond);
            }
        }
    }
}

}  // namespace ink::bench
