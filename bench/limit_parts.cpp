#include "bench/limit_parts.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>

#include "bench/bench_scene.h"
#include "edge/laplacian.h"

namespace ink::bench {

SmoothValue::SmoothValue(const scene::View& view) {
    const scene::Camera& camera = view.camera;
    const double span = camera.far - camera.near;
    value_.base = 95 - 64 * camera.near / span;
    value_.per_q = 64 * camera.near * camera.far / span;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dmat3& m = camera.view_from_world;
        value_.per_normal[axis] = static_cast<float>(31.75 * (m[axis][0] + m[axis][1]));
    }
}

void SmoothValue::compute(const raster::CornerBatch& in, const raster::CornerPlanes& out) const {
    raster::compute_linear(&value_, 1, false, in, out);
}

void LimitSink::finish(const raster::Tile& tile) {
    const void* depth = tile.depth;
    benchmark::DoNotOptimize(depth);
    if (!filters_) return;
    const core::ImageView<std::uint8_t> to{
        out_.row(tile.y0_px) + tile.x0_px, tile.width_px, tile.height_px, out_.width_px()};
    if (tile.is_empty) {
        for (int y = 0; y < tile.height_px; ++y)
            std::fill_n(to.row(y), tile.width_px, std::uint8_t{0});
        return;
    }
    edge::laplacian(
        {tile.row<std::uint8_t>(0, 0), tile.width_px, tile.height_px, tile.stride}, to, {});
}

raster::PassFormat limit_format() {
    raster::PassFormat format;
    format.store = raster::Store::u8;
    format.halo_px = 1;
    return format;
}

raster::MeshInput limit_input(const std::string& mesh, const scene::View& view) {
    raster::MeshInput input;
    input.mesh = &lane_mesh(mesh);
    input.view = view;
    input.bounds = scene::bounding_sphere(bench_scene(mesh));
    return input;
}

const raster::LaneMesh& lane_mesh(const std::string& name) {
    static std::map<std::string, raster::LaneMesh> kept;
    return kept.try_emplace(name, bench_surface(name)).first->second;
}

}  // namespace ink::bench
