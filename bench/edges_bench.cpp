#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

#include "bench/bench_scene.h"
#include "bench/benchmarks.h"
#include "buffers/vertex_weld.h"
#include "catalogue/catalogue.h"
#include "catalogue/shapes.h"
#include "core/hash.h"
#include "methods/edge_hash/soup_models.h"
#include "methods/edge_list/edge_builders.h"

namespace ink::bench {
namespace {

using methods::EdgeBuilder;
using Triangles = std::vector<scene::Triangle>;

Triangles welded(const std::vector<glm::dvec3>& points, const Triangles& triangles) {
    const buffers::VertexWeld weld = buffers::weld_vertices(points, 0);
    return buffers::weld_faces(weld, points, triangles, buffers::DoubleFaces::keep).faces;
}

Triangles welded(const scene::Mesh& mesh) {
    return welded({mesh.positions.begin(), mesh.positions.end()}, mesh.triangles);
}

/// The catalogue's rocket as one list: 100 triangles, 150 edges, as many as CoRgi's had.
Triangles rocket() {
    const scene::Surface surface = scene::flatten(catalogue::make_catalogue_scene("rocket"));
    return welded(surface.p_world, surface.triangles);
}

Triangles mixed(Triangles triangles) {
    std::mt19937 random(7);
    for (std::size_t i = triangles.size() - 1; i > 0; --i)
        std::swap(triangles[i], triangles[random() % (i + 1)]);
    return triangles;
}

/// Made at its first use and kept. `rocket_mixed` is the rocket, its triangles in a mixed order;
/// `ball` has 1280 triangles.
const Triangles& triangles_of(const std::string& mesh) {
    static std::map<std::string, Triangles> kept;
    Triangles& triangles = kept[mesh];
    if (!triangles.empty()) return triangles;
    if (mesh == "rocket") triangles = rocket();
    if (mesh == "rocket_mixed") triangles = mixed(rocket());
    if (mesh == "ball") triangles = welded(catalogue::make_icosphere(1, 3));
    if (triangles.empty()) {
        const scene::Surface surface = scene::flatten(bench_scene(mesh));
        triangles = welded(surface.p_world, surface.triangles);
    }
    return triangles;
}

/// The same for every builder that finds the same edges.
std::string hash_of(std::vector<methods::ListedEdge> edges) {
    std::sort(edges.begin(), edges.end(), [](const auto& x, const auto& y) {
        return std::tie(x.a, x.b, x.faces) < std::tie(y.a, y.b, y.faces);
    });
    core::Hasher hasher;
    for (const methods::ListedEdge& edge : edges)
        hasher.value(edge.a).value(edge.b).value(edge.faces);
    return hasher.hex();
}

void time_builder(benchmark::State& state, EdgeBuilder builder, const std::string& mesh) {
    const Triangles& triangles = triangles_of(mesh);
    methods::EdgeListing listing;
    for (auto _ : state) {
        listing = methods::list_edges(triangles, builder);
        benchmark::DoNotOptimize(listing.edges.data());
    }
    const std::string hash = hash_of(listing.edges);
    if (hash != hash_of(methods::list_edges(triangles, EdgeBuilder::hash).edges))
        state.SkipWithError("not the edges that a hash table finds");
    state.SetLabel(hash);
    state.counters["triangles"] = static_cast<double>(triangles.size());
    state.counters["edges"] = static_cast<double>(listing.edges.size());
    state.counters["comparisons"] = static_cast<double>(listing.counts.comparisons);
    state.counters["per_side"] = listing.counts.comparisons_per_lookup();
    state.counters["longest"] = static_cast<double>(listing.counts.longest);
}

/// Two frames of an animation of the mesh.
std::array<scene::Scene, 2> frames_of(const std::string& mesh) {
    std::array<scene::Scene, 2> frames;
    frames.fill(mesh == "rocket" ? catalogue::make_catalogue_scene("rocket") : bench_scene(mesh));
    for (glm::vec3& p : frames[1].meshes[0].positions)
        p.y *= 1.25F;
    return frames;
}

/// What TechnicalQuake's cache saves: a new frame of a model, or one that was there before.
void time_frames(benchmark::State& state, std::size_t most_frames, const std::string& mesh) {
    const auto frames = frames_of(mesh);
    methods::SoupModels models(
        {.epsilon = 1e-5, .most_frames = most_frames, .crease_rad = 0.6981317007977318});
    models.prepare(frames[0]);
    for (const scene::Scene& frame : frames)
        models.pose(frame);
    std::size_t i = 0;
    for (auto _ : state)
        models.pose(frames[i++ % 2]);
    models.pose(frames[0]);
    const methods::SoupTotals totals = models.totals();
    state.SetLabel(core::Hasher().value(totals.edges).value(totals.boundary).hex());
    state.counters["edges"] = static_cast<double>(totals.edges);
}

}  // namespace

void add_edge_benchmarks() {
    const auto add = [](const std::string& name, auto time, auto what, const std::string& mesh) {
        benchmark::RegisterBenchmark((name + "/" + mesh).c_str(), time, what, mesh)
            ->Unit(benchmark::kMicrosecond);
    };
    std::vector<std::string> meshes{"rocket", "rocket_mixed", "ball"};
    for (const std::string& mesh : mesh_names()) {
        if (mesh == "sphere" || mesh == "dragon_coarse") meshes.push_back(mesh);
    }
    const std::array<std::pair<EdgeBuilder, std::string>, 3> builders{
        {{EdgeBuilder::all_pairs, "all_pairs"},
         {EdgeBuilder::temp_list, "temp_list"},
         {EdgeBuilder::hash, "hash"}}};
    for (const std::string& mesh : meshes) {
        const bool is_large = mesh == "sphere" || mesh == "dragon_coarse";
        for (const auto& [builder, name] : builders) {
            if (is_large && builder == EdgeBuilder::all_pairs) continue;  // 2e10 comparisons
            add("edges/" + name, time_builder, builder, mesh);
        }
        if (mesh == "rocket" || is_large) {
            // Room for one frame: each pose is a first one.
            add("edge_hash/first", time_frames, std::size_t{1}, mesh);
            add("edge_hash/cached", time_frames, std::size_t{2}, mesh);
        }
    }
}

}  // namespace ink::bench
