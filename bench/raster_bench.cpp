#include <benchmark/benchmark.h>

#include <array>
#include <map>
#include <mutex>
#include <vector>

#include "bench/benchmarks.h"
#include "buffers/each_tile.h"
#include "core/hash.h"
#include "raster/mesh/mesh_pass.h"

namespace ink::bench {
namespace {

/// Values as methods give them: the view-space normal's components and 1/w, each spread over a
/// byte; a single value is the sum of quarters of all four, as `mote4` has it.
class Values : public raster::CornerValues {
  public:
    Values(const scene::View& view, int count) {
        const scene::Camera& camera = view.camera;
        std::array<raster::LinearValue, 4> channels;
        for (int i = 0; i < 3; ++i) {
            channels[static_cast<std::size_t>(i)].base = 127.5;
            for (int axis = 0; axis < 3; ++axis) {
                channels[static_cast<std::size_t>(i)].per_normal[axis] =
                    static_cast<float>(camera.view_from_world[axis][i] * 127.5);
            }
        }
        const double span = camera.far - camera.near;
        channels[3].base = -255 * camera.near / span;
        channels[3].per_q = 255 * camera.near * camera.far / span;
        values_.assign(channels.begin(), channels.begin() + count);
        if (count == 1) values_[0] = mean_of(channels);
    }

    void compute(const raster::CornerBatch& in, const raster::CornerPlanes& out) const override {
        raster::compute_linear(values_.data(), static_cast<int>(values_.size()), false, in, out);
    }

  private:
    static raster::LinearValue mean_of(const std::array<raster::LinearValue, 4>& channels) {
        raster::LinearValue mean;
        for (const raster::LinearValue& channel : channels) {
            mean.base += channel.base / 4;
            mean.per_q += channel.per_q / 4;
            for (int axis = 0; axis < 3; ++axis)
                mean.per_normal[axis] += channel.per_normal[axis] / 4;
        }
        return mean;
    }

    std::vector<raster::LinearValue> values_;
};

/// A mesh laid out as the rasterizer takes it; made once.
const raster::LaneMesh& lane_mesh(const std::string& name) {
    static std::map<std::string, raster::LaneMesh> kept;
    return kept.try_emplace(name, bench_surface(name)).first->second;
}

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
        const std::lock_guard lock(mutex_);
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
        return format_.store == raster::Store::u8 ? 1 : 4;
    }
    [[nodiscard]] const char* plane_row(const raster::Tile& tile, int plane, int y) const {
        const auto* origin = static_cast<const char*>(tile.planes[static_cast<std::size_t>(plane)]);
        return origin + y * tile.stride * static_cast<std::ptrdiff_t>(plane_bytes());
    }

    raster::PassFormat format_;
    std::mutex mutex_;
    std::map<std::pair<int, int>, std::uint64_t> tiles_;
};

struct PassKey {
    raster::PassFormat format;
    std::string mesh;
};

/// One pass: from world positions to finished tiles. The two views come in turns.
void time_pass(benchmark::State& state, const PassKey& key, int threads) {
    const auto views = bench_views(bench_scene(key.mesh));
    std::vector<Values> values;
    std::array<raster::MeshInput, 2> inputs;
    for (const scene::View& view : views)
        values.emplace_back(view, key.format.interpolants);
    for (std::size_t i = 0; i < 2; ++i) {
        inputs[i].mesh = &lane_mesh(key.mesh);
        inputs[i].values = &values[i];
        inputs[i].view = views[i];
        inputs[i].threads = threads;
    }
    raster::MeshPass pass;
    const auto draw = [&](std::size_t view, raster::TileSink& sink) {
        benchmark::DoNotOptimize(pass.draw(key.format, inputs[view], sink));
    };
    HashSink hashes(key.format);
    draw(0, hashes);
    // Does nothing with tiles: what is timed is the rasterizer.
    buffers::EachTile sink([](const raster::Tile& tile) {
        const void* depth = tile.depth;
        benchmark::DoNotOptimize(depth);
    });
    std::size_t frame = 1;
    for (auto _ : state) {
        draw(frame % 2, sink);
        ++frame;
    }
    HashSink again(key.format);
    draw(0, again);
    if (again.hex() != hashes.hex()) state.SkipWithError("the pass changed when drawn again");
    state.SetLabel(hashes.hex());
    state.counters["triangles"] = static_cast<double>(scene::triangle_count(bench_scene(key.mesh)));
    state.counters["bytes_per_px"] = key.format.bytes_per_px();
}

}  // namespace

void add_raster_benchmarks(int draws) {
    using raster::Store;
    for (const std::string& mesh : mesh_names()) {
        const auto add_pass = [&](const std::string& name, int interpolants, Store store) {
            const raster::PassFormat format{
                .interpolants = interpolants, .store = store, .halo_px = 1};
            add_with_threads(
                "raster/" + name + "/" + mesh + "/1080p", draws, time_pass, {format, mesh});
        };
        add_pass("u8", 1, Store::u8);
        add_pass("f32x4", 4, Store::f32);
    }
}

}  // namespace ink::bench
