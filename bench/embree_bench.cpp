// What Embree's rays cost: a frame before it is shaded, and a truth by brute force.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bench/benchmarks.h"
#include "core/hash.h"
#include "core/image.h"
#include "truth/embree.h"

namespace ink::bench {
namespace {

/// A square of 4 x 4 rays, row by row.
constexpr int kPacketSide = 4;
constexpr int kPacket = kPacketSide * kPacketSide;
using PacketIds = std::array<std::uint32_t, kPacket>;

alignas(64) constexpr std::array<int, kPacket> kAll = {
    -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};

/// Every triangle as a face, in order, and nothing welded.
scene::Topology unwelded(const scene::Scene& scene) {
    scene::Surface surface = scene::flatten(scene);
    scene::Topology topology;
    topology.p_world = std::move(surface.p_world);
    for (const scene::Triangle& triangle : surface.triangles)
        topology.faces.push_back({triangle});
    return topology;
}

/// A scene in Embree's robust tree, looked at by coherent packets of 16 rays from a view's eye, on
/// one thread and without a filter: the fastest that Embree does this.
class RayTree {
  public:
    RayTree(const scene::Scene& scene, const scene::View& view)
        : near_(static_cast<float>(view.camera.near)) {
        const scene::Projection projection(view);
        corner_ = projection.ray_world(0, 0);
        right_ = projection.ray_world(1, 0) - corner_;
        down_ = projection.ray_world(0, 1) - corner_;
        truth::embree::build(handles_, unwelded(scene), 1, "bench", [&](const glm::dvec3& p_world) {
            return p_world - view.camera.eye_world;
        });
    }

    /// The global indices of the triangles seen by 4 x 4 rays from (x_px, y_px) on, `step_px` apart
    /// each way; 0xffffffff where there is sky.
    [[nodiscard]] PacketIds cast(double x_px, double y_px, double step_px) const {
        const glm::vec3 first(corner_ + x_px * right_ + y_px * down_);
        const glm::vec3 right(step_px * right_);
        const glm::vec3 down(step_px * down_);
        RTCRayHit16 packet{};  // from the eye, which is the origin
        for (int i = 0; i < kPacket; ++i) {
            const auto x = static_cast<float>(i % kPacketSide);
            const auto y = static_cast<float>(i / kPacketSide);
            packet.ray.dir_x[i] = first.x + x * right.x + y * down.x;
            packet.ray.dir_y[i] = first.y + x * right.y + y * down.y;
            packet.ray.dir_z[i] = first.z + x * right.z + y * down.z;
            packet.ray.tnear[i] = near_;
            packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
            packet.ray.mask[i] = 0xffffffffU;
            packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            packet.hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        truth::embree::Context context;
        truth::embree::init_context(context);
        truth::embree::intersect_16(kAll.data(), handles_.scene, context, nullptr, packet);
        PacketIds ids;
        std::copy(packet.hit.primID, packet.hit.primID + kPacket, ids.begin());
        return ids;
    }

  private:
    truth::embree::Handles handles_;
    float near_;
    glm::dvec3 corner_;  ///< the ray's direction at the image's top left corner ...
    glm::dvec3 right_;   ///< ... and what a pixel adds to it
    glm::dvec3 down_;
};

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
    explicit DenseRays(const scene::Scene& scene) : tree_(scene, bench_views(scene)[0]) {}

    // 256 rays in every pixel.
    [[nodiscard]] DenseCounts cast_everywhere() const {
        Mixed mixed;
        for (int y = 0; y < kHeight_px; ++y) {
            for (int x = 0; x < kWidth_px; ++x) {
                if (is_mixed(x, y)) mixed.add(x, y);
            }
        }
        return mixed.with(static_cast<std::size_t>(kWidth_px) * kHeight_px * kGrid * kGrid);
    }

    // One ray at each corner of the pixels, and the 256 only in pixels whose corners, with those
    // of the eight pixels round them, do not all see one triangle.
    [[nodiscard]] DenseCounts cast_adaptive() const {
        // Rays at the pixels' own corners are shared by four pixels: a pixel whose corners and
        // those of its eight neighbours see one triangle is taken to show nothing else.
        const auto whole = [](int n) { return (n + kPacketSide) / kPacketSide * kPacketSide; };
        const int columns = whole(kWidth_px);
        const int rows = whole(kHeight_px);
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
        for (int y = 0; y < kHeight_px; ++y) {
            for (int x = 0; x < kWidth_px; ++x) {
                const std::uint32_t id = corner[static_cast<std::size_t>(y) * columns + x];
                bool is_pure = true;
                for (int j = std::max(0, y - 1); j <= std::min(y + 2, kHeight_px) && is_pure; ++j) {
                    for (int i = std::max(0, x - 1); i <= std::min(x + 2, kWidth_px); ++i)
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
};

/// What a truth without lines would cost: 16 x 16 rays in each pixel, or only where a pixel's
/// corners and centre see different triangles.
void time_dense(benchmark::State& state, const std::string& mesh, bool is_adaptive) {
    const DenseRays rays(bench_scene(mesh));
    DenseCounts counts;
    for (auto _ : state)
        counts = is_adaptive ? rays.cast_adaptive() : rays.cast_everywhere();
    state.SetLabel(counts.hash);
    state.counters["rays"] = static_cast<double>(counts.rays);
    state.counters["mixed_px"] = static_cast<double>(counts.mixed_px);
}

}  // namespace

void add_embree_benchmarks() {
    for (const std::string& mesh : mesh_names()) {
        add("embree/primary/" + mesh + "/1080p/threads:1", time_primary, mesh);
        add("truth_dense/" + mesh + "/1080p", time_dense, mesh, false);
        add("truth_adaptive/" + mesh + "/1080p", time_dense, mesh, true);
    }
}

}  // namespace ink::bench
