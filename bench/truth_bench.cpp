#include <benchmark/benchmark.h>

#include <algorithm>
#include <span>
#include <vector>

#include "bench/bench_scene.h"
#include "bench/benchmarks.h"
#include "bench/ray_tree.h"
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

struct DenseCounts {
    std::size_t rays = 0;
    std::size_t mixed_px = 0;  ///< pixels in which more than one triangle, or the sky, is seen
    std::string hash;          ///< of which these are
};

constexpr int kGrid = 16;  ///< rays a pixel, each way

bool is_one(const PacketIds& ids, std::uint32_t id) {
    return std::all_of(ids.begin(), ids.end(), [id](std::uint32_t i) { return i == id; });
}

/// Counts mixed pixels and remembers which.
class Mixed {
  public:
    void add(int x, int y) {
        ++count_;
        places_.value(x).value(y);
    }
    [[nodiscard]] DenseCounts with(std::size_t rays) const { return {rays, count_, places_.hex()}; }

  private:
    std::size_t count_ = 0;
    core::Hasher places_;
};

// A truth by brute force, as a renderer would make it: triangle ids of 16 x 16 rays a pixel.
class DenseRays {
  public:
    DenseRays(const scene::Scene& scene, const scene::View& view)
        : tree_(scene, view), width_px_(view.width_px), height_px_(view.height_px) {}

    // 256 rays in every pixel.
    [[nodiscard]] DenseCounts cast_everywhere() const {
        Mixed mixed;
        for (int y = 0; y < height_px_; ++y) {
            for (int x = 0; x < width_px_; ++x) {
                if (is_mixed(x, y)) mixed.add(x, y);
            }
        }
        return mixed.with(static_cast<std::size_t>(width_px_) * height_px_ * kGrid * kGrid);
    }

    // One ray at each corner of the pixels, and the 256 only in pixels whose corners, with those
    // of the eight pixels round them, do not all see one triangle.
    [[nodiscard]] DenseCounts cast_adaptive() const {
        // Rays at the pixels' own corners are shared by four pixels: a pixel whose corners and
        // those of its eight neighbours see one triangle is taken to show nothing else.
        const auto whole = [](int n) { return (n + kPacketSide) / kPacketSide * kPacketSide; };
        const int columns = whole(width_px_);
        const int rows = whole(height_px_);
        std::vector<std::uint32_t> corner(static_cast<std::size_t>(columns) * rows);
        for (int y = 0; y < rows; y += kPacketSide) {
            for (int x = 0; x < columns; x += kPacketSide) {
                const PacketIds ids = tree_.cast(x, y, 1);
                for (int i = 0; i < kPacket; ++i)
                    corner[static_cast<std::size_t>(y + i / kPacketSide) * columns + x +
                           i % kPacketSide] = ids[static_cast<std::size_t>(i)];
            }
        }
        Mixed mixed;
        std::size_t rays = corner.size();
        for (int y = 0; y < height_px_; ++y) {
            for (int x = 0; x < width_px_; ++x) {
                const std::uint32_t id = corner[static_cast<std::size_t>(y) * columns + x];
                bool is_pure = true;
                for (int j = std::max(0, y - 1); j <= std::min(y + 2, height_px_) && is_pure; ++j) {
                    for (int i = std::max(0, x - 1); i <= std::min(x + 2, width_px_); ++i)
                        is_pure =
                            is_pure && corner[static_cast<std::size_t>(j) * columns + i] == id;
                }
                if (is_pure) continue;
                rays += kGrid * kGrid;
                if (is_mixed(x, y)) mixed.add(x, y);
            }
        }
        return mixed.with(rays);
    }

  private:
    /// All 256 rays of a pixel; whether they see more than one thing.
    [[nodiscard]] bool is_mixed(int x, int y) const {
        constexpr double kStep = 1.0 / kGrid;
        bool is_pure = true;
        std::uint32_t first = 0;
        for (int block = 0; block < kGrid * kGrid / kPacket; ++block) {
            const PacketIds ids = tree_.cast(x + (block % kPacketSide * kPacketSide + 0.5) * kStep,
                                             y + (block / kPacketSide * kPacketSide + 0.5) * kStep,
                                             kStep);
            if (block == 0) first = ids[0];
            is_pure = is_pure && is_one(ids, first);
        }
        return !is_pure;
    }

    RayTree tree_;
    int width_px_;
    int height_px_;
};

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

/// What a truth without lines would cost: 16 x 16 rays in each pixel, or only where a pixel's
/// corners and centre see different triangles.
void time_dense(benchmark::State& state, const std::string& mesh, bool is_adaptive) {
    const scene::Scene& scene = bench_scene(mesh);
    const DenseRays rays(scene, bench_views(scene)[0]);
    DenseCounts counts;
    for (auto _ : state)
        counts = is_adaptive ? rays.cast_adaptive() : rays.cast_everywhere();
    state.SetLabel(counts.hash);
    state.counters["rays"] = static_cast<double>(counts.rays);
    state.counters["mixed_px"] = static_cast<double>(counts.mixed_px);
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
        add("truth_dense/" + mesh + "/1080p", time_dense, mesh, false);
        add("truth_adaptive/" + mesh + "/1080p", time_dense, mesh, true);
    }
}

}  // namespace ink::bench
