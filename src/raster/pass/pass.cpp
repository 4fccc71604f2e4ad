#include "raster/pass/pass.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "raster/pass/bin.h"
#include "raster/pass/tile_buffer.h"
#include "raster/pass/tile_fill.h"
#include "raster/pass/triangle_stage.h"

namespace ink::raster {
namespace {

/// What the types cannot say; every breach is a caller's bug.
void check(const PassFormat& format, const PassInput& input) {
    [[maybe_unused]] const std::size_t values =
        input.p_clip.size() * static_cast<std::size_t>(format.interpolants);
    assert(format.halo_px >= 0 && format.halo_px <= kMaxHalo_px);
    assert(input.near > 0 && std::isfinite(input.near));
    assert(format.depth == DepthFormat::q32 || input.far > input.near);
    assert(input.values.size() >= values);
    assert(input.values_back.empty() || input.values_back.size() >= values);
    assert(input.facing.empty() || input.facing.size() == input.triangles.size());
    assert(!format.constant || input.constants.size() == input.triangles.size());
    assert(format.interpolants > 0 || format.store == Store::none || format.constant);
    assert(!format.constant || format.store != Store::f32);
}

/// One thread's share of the tiles: it takes the next one until none is left.
void fill_tiles(const FillJob& job,
                const TileGrid& grid,
                const Bins& bins,
                std::atomic<int>& next_tile,
                TileSink& sink) {
    TileBuffer buffer(job.format, job.input, grid);
    for (int tile = next_tile++; tile < grid.count(); tile = next_tile++) {
        buffer.start(tile);
        if (!bins.of(tile).empty()) buffer.touch();
        const bool is_empty = !fill_tile(job, bins.of(tile), buffer);
        buffer.finish();
        if (!is_empty) buffer.extend_frame();
        sink.finish(buffer.view(is_empty));
    }
}

}  // namespace

int PassFormat::bytes_per_px() const {
    const int depth_bytes = depth == DepthFormat::q32 ? 4 : depth == DepthFormat::z24 ? 3 : 2;
    return depth_bytes + static_cast<int>(bytes_of(store)) * planes();
}

void draw_pass(const PassFormat& format,
               const PassInput& input,
               int width_px,
               int height_px,
               int threads,
               TileSink& sink) {
    assert(width_px >= 0 && height_px >= 0);
    check(format, input);
    if (width_px == 0 || height_px == 0) return;

    const TileGrid grid{width_px, height_px, format.halo_px};
    const std::vector<Batch> batches =
        set_up_batches(format, input, {0, 0, width_px, height_px}, threads);
    const Bins bins(grid, batches, threads);
    const FillJob job{format, input, batches};
    std::atomic<int> next_tile = 0;
    const auto shares = static_cast<std::size_t>(std::clamp(threads, 1, grid.count()));
    core::parallel_for(
        shares, threads, [&](std::size_t) { fill_tiles(job, grid, bins, next_tile, sink); });
}

}  // namespace ink::raster
