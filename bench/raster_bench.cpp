#include <benchmark/benchmark.h>

#include <map>
#include <tuple>

#include "bench/bench_scene.h"
#include "bench/benchmarks.h"
#include "core/hash.h"
#include "raster/pass.h"
#include "scene/surface.h"

namespace ink::bench {
namespace {

/// A mesh as a pass takes it, seen from one view.
struct Load {
    std::vector<glm::dvec3> p_clip;
    std::vector<scene::Triangle> triangles;
    std::vector<float> values;  ///< interpolants of them per vertex
    raster::PassInput input;
};

/// Values as methods give them: view-space normal and depth, scaled to a byte.
float value_at(int i, const glm::vec3& normal, double w, const scene::Camera& camera) {
    const double depth = (camera.far - w) / (camera.far - camera.near);
    const double channel = i < 3 ? (normal[i] + 1) / 2 : depth;
    return static_cast<float>(channel * 255);
}

void fill_load(const scene::Surface& surface,
               const scene::View& view,
               int interpolants,
               Load& load) {
    const scene::Projection projection(view);
    for (std::size_t v = 0; v < surface.p_world.size(); ++v) {
        load.p_clip.push_back(projection.to_clip(surface.p_world[v]));
        for (int i = 0; i < interpolants; ++i) {
            load.values.push_back(
                value_at(i, surface.n_world[v], load.p_clip.back().z, view.camera));
        }
    }
    load.triangles = surface.triangles;
    load.input.p_clip = load.p_clip;
    load.input.triangles = load.triangles;
    load.input.values = load.values;
    load.input.near = view.camera.near;
    load.input.far = view.camera.far;
}

/// Takes tiles and does nothing with them: what is timed is the rasterizer.
class NoSink : public raster::TileSink {
  public:
    void finish(const raster::Tile& tile) override { benchmark::DoNotOptimize(tile.depth); }
};

/// Hashes depth and planes of every tile; the order of tiles does not matter.
class HashSink : public raster::TileSink {
  public:
    explicit HashSink(const raster::PassFormat& format) : format_(format) {}

    void finish(const raster::Tile& tile) override {
        core::Hasher hasher;
        const auto width = static_cast<std::size_t>(tile.width_px);
        for (int y = 0; y < tile.height_px; ++y) {
            hasher.bytes(tile.depth_row<std::uint32_t>(y), width * sizeof(std::uint32_t));
            for (int i = 0; i < format_.planes(); ++i)
                hasher.bytes(plane_row(tile, i, y), width * plane_bytes());
        }
        tiles_[{tile.y0_px, tile.x0_px}] = hasher.result();
    }

    [[nodiscard]] std::string hex() const {
        core::Hasher hasher;
        for (const auto& [place, hash] : tiles_)
            hasher.value(hash);
        return hasher.hex();
    }

  private:
    [[nodiscard]] std::size_t plane_bytes() const {
        return format_.store == raster::Store::u8 ? 1 : format_.store == raster::Store::u16 ? 2 : 4;
    }
    [[nodiscard]] const char* plane_row(const raster::Tile& tile, int plane, int y) const {
        const auto* origin = static_cast<const char*>(tile.planes[static_cast<std::size_t>(plane)]);
        return origin + y * tile.stride * static_cast<std::ptrdiff_t>(plane_bytes());
    }

    raster::PassFormat format_;
    std::map<std::pair<int, int>, std::uint64_t> tiles_;
};

/// A mesh and a picture, and what a vertex carries.
struct LoadKey {
    std::string mesh;
    PictureSize size;
    int interpolants = 0;
};

const scene::Surface& surface_of(const std::string& mesh) {
    static std::map<std::string, scene::Surface> kept;
    const auto found = kept.find(mesh);
    if (found != kept.end()) return found->second;
    constexpr double kCrease_rad = 0.6981317007977318;
    return kept
        .emplace(mesh, scene::flatten(bench_scene(mesh), scene::NormalSource::patch, kCrease_rad))
        .first->second;
}

/// Both views; made once, for every repetition asks for them again.
const std::array<Load, 2>& loads_of(const LoadKey& key) {
    static std::map<std::tuple<std::string, std::string, int>, std::array<Load, 2>> kept;
    const auto [entry, is_new] = kept.try_emplace({key.mesh, key.size.name, key.interpolants});
    if (is_new) {
        const auto views = bench_views(bench_scene(key.mesh), key.size);
        for (std::size_t i = 0; i < 2; ++i)
            fill_load(surface_of(key.mesh), views[i], key.interpolants, entry->second[i]);
    }
    return entry->second;
}

void time_pass(benchmark::State& state,
               const raster::PassFormat& format,
               const LoadKey& key,
               int threads) {
    const std::array<Load, 2>& loads = loads_of(key);
    const int width_px = key.size.width_px;
    const int height_px = key.size.height_px;
    NoSink sink;
    std::size_t frame = 0;
    for (auto _ : state) {
        raster::draw_pass(format, loads[frame % 2].input, width_px, height_px, threads, sink);
        ++frame;
    }
    HashSink hashes(format);
    const raster::PassStats stats =
        raster::draw_pass(format, loads[0].input, width_px, height_px, 1, hashes);
    state.SetLabel(hashes.hex());
    state.counters["triangles"] = static_cast<double>(stats.triangles);
    state.counters["bytes_per_px"] = format.bytes_per_px();
}

raster::PassFormat format_of(int interpolants, raster::Store store) {
    raster::PassFormat format;
    format.interpolants = interpolants;
    format.store = store;
    format.halo_px = 1;
    return format;
}

}  // namespace

void add_raster_benchmarks(int draws) {
    using raster::Store;
    const std::vector<std::pair<std::string, raster::PassFormat>> formats = {
        {"depth", format_of(0, Store::none)},
        {"u8", format_of(1, Store::u8)},
        {"u8x2", format_of(2, Store::u8)},
        {"u16", format_of(1, Store::u16)},
        {"f32x4", format_of(4, Store::f32)},
    };
    const auto add = [draws](const std::string& name, const auto& format, const LoadKey& key) {
        for (const int threads : {1, 2}) {
            auto* added =
                benchmark::RegisterBenchmark((name + "/threads:" + std::to_string(threads)).c_str(),
                                             [format, key, threads](benchmark::State& state) {
                                                 time_pass(state, format, key, threads);
                                             });
            added->Unit(benchmark::kMillisecond);
            if (draws > 0) added->Iterations(draws);
        }
    };
    for (const std::string& mesh : mesh_names()) {
        for (const auto& [name, format] : formats) {
            for (const PictureSize& size : picture_sizes()) {
                add("raster/" + name + "/" + mesh + "/" + size.name,
                    format,
                    {mesh, size, format.interpolants});
            }
        }
    }
}

}  // namespace ink::bench
