#include <benchmark/benchmark.h>

#include <span>
#include <vector>

#include "bench/benchmarks.h"
#include "core/hash.h"
#include "truth/curve_facts.h"
#include "truth/eye_scene.h"
#include "truth/eye_view.h"
#include "truth/model.h"
#include "truth/trace_layers.h"
#include "truth/trace_lines.h"
#include "truth/truth.h"

namespace ink::bench {
namespace {

void count_lines(benchmark::State& state, std::size_t samples, std::size_t rays) {
    state.counters["samples"] = static_cast<double>(samples);
    state.counters["rays"] = static_cast<double>(rays);
}

/// The whole truth of a view, from the scene: topology, Embree's tree, lines, visibility, layers.
void time_truth(benchmark::State& state, const std::string& mesh) {
    const scene::Scene& scene = bench_scene(mesh);
    const scene::View view = bench_views(scene)[0];
    truth::Truth truth;
    for (auto _ : state)
        truth = truth::trace_truth(scene, view, {});
    state.SetLabel(core::image_hash(truth.labels));
    count_lines(state, truth.counts.samples, truth.counts.rays);
}

/// What no eye changes: weld, edges, crossings.
void time_model(benchmark::State& state, const std::string& mesh) {
    const scene::Scene& scene = bench_scene(mesh);
    truth::Model model;
    for (auto _ : state)
        model = truth::build_model(scene, {});
    state.SetLabel(core::Hasher()
                       .items(std::span<const std::uint32_t>(model.topology.edge_faces))
                       .items(std::span<const std::uint32_t>(model.patch))
                       .hex());
}

/// A model with what one eye makes of it, for the stages after.
struct Stage {
    scene::View view;
    truth::Model model;
    truth::EyeView eye;
    truth::EyeScene scene;

    explicit Stage(const std::string& mesh)
        : view(bench_views(bench_scene(mesh))[0]),
          model(truth::build_model(bench_scene(mesh), {})),
          eye(model, view, 1),
          scene(model.topology, view.camera, 1) {}
};

void time_eye(benchmark::State& state, const std::string& mesh) {
    const Stage stage(mesh);
    for (auto _ : state)
        benchmark::DoNotOptimize(truth::EyeView(stage.model, stage.view, 1));
    const truth::EyeView eye(stage.model, stage.view, 1);
    state.SetLabel(core::Hasher()
                       .items(std::span<const std::int8_t>(eye.facing))
                       .items(std::span<const truth::LineClass>(eye.edge_class))
                       .hex());
}

void time_bvh(benchmark::State& state, const std::string& mesh) {
    const Stage stage(mesh);
    for (auto _ : state) {
        const truth::EyeScene tree(stage.model.topology, stage.view.camera, 1);
        benchmark::DoNotOptimize(&tree);
    }
    // A tree shows no bits of its own: what it says of every pixel stands for it.
    const truth::EyeScene tree(stage.model.topology, stage.view.camera, 1);
    state.SetLabel(core::image_hash(truth::trace_layers(stage.eye, tree, 1).layers.triangle));
}

/// The lines alone, visibility and what lies behind them included.
void time_lines(benchmark::State& state, const std::string& mesh) {
    const Stage stage(mesh);
    truth::TracedLines lines;
    for (auto _ : state) {
        lines = truth::trace_lines(stage.eye, stage.scene, {});
        lines.rays += truth::fill_curve_facts(stage.eye, stage.scene, lines.curves, 1);
    }
    core::Hasher hasher;
    for (const truth::Curve& curve : lines.curves) {
        hasher.value(curve.line_class).value(curve.edge).value(curve.gap);
        hasher.value(curve.begin.x_px).value(curve.begin.y_px);
        hasher.value(curve.end.x_px).value(curve.end.y_px);
    }
    state.SetLabel(hasher.hex());
    count_lines(state, lines.samples, lines.rays);
}

void time_layers(benchmark::State& state, const std::string& mesh) {
    const Stage stage(mesh);
    truth::TracedLayers layers;
    for (auto _ : state)
        layers = truth::trace_layers(stage.eye, stage.scene, 1);
    state.SetLabel(core::image_hash(layers.layers.triangle));
    state.counters["rays"] = static_cast<double>(layers.face.size());
}

}  // namespace

void add_truth_benchmarks() {
    for (const std::string& mesh : mesh_names()) {
        const std::string name = "truth/" + mesh + "/1080p";
        add(name, time_truth, mesh);
        add(name + "/model", time_model, mesh);
        add(name + "/eye", time_eye, mesh);
        add(name + "/bvh", time_bvh, mesh);
        add(name + "/lines", time_lines, mesh);
        add(name + "/layers", time_layers, mesh);
    }
}

}  // namespace ink::bench
