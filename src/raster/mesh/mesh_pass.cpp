#include "raster/mesh/mesh_pass.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>

#include "core/parallel.h"
#include "raster/mesh/front_depth.h"
#include "raster/mesh/mesh_stage.h"
#include "raster/mesh/mesh_tiles.h"

namespace ink::raster {
namespace {

void add(SkipCounts& to, const SkipCounts& from) {
    for (std::size_t i = 0; i < kSkipCount; ++i) {
        to[i].skipped += from[i].skipped;
        to[i].of += from[i].of;
    }
}

}  // namespace

/// What is kept from frame to frame.
struct MeshPass::Scratch {
    std::vector<MeshRun> runs;
    FrontDepth front;
    std::vector<std::uint64_t> objects;  ///< per tile, of the last frame
};

namespace {

/// Marks the tiles that nothing which moved touches, now or in the last frame.
void find_still_tiles(const MeshInput& input,
                      const std::vector<MeshRun>& runs,
                      std::vector<std::uint64_t>& last,
                      std::vector<std::uint8_t>& still) {
    const bool has_last = input.moved_objects && last.size() == still.size();
    const std::uint64_t moved = input.moved_objects.value_or(~std::uint64_t{0});
    last.resize(still.size(), ~std::uint64_t{0});
    for (std::size_t tile = 0; tile < still.size(); ++tile) {
        std::uint64_t now = 0;
        for (const MeshRun& run : runs)
            now |= run.objects(static_cast<int>(tile));
        still[tile] = has_last && ((now | last[tile]) & moved) == 0 ? 1 : 0;
        last[tile] = now;
    }
}

}  // namespace

MeshPass::MeshPass() : scratch_(std::make_unique<Scratch>()) {}
MeshPass::~MeshPass() = default;
MeshPass::MeshPass(MeshPass&&) noexcept = default;
MeshPass& MeshPass::operator=(MeshPass&&) noexcept = default;

MeshResult MeshPass::draw(const PassFormat& asked, const MeshInput& input, TileSink& sink) {
    MeshResult result;
    const scene::View& view = input.view;
    PassFormat format = asked;
    // What is linear on a surface is so on the screen.
    if (view.camera.is_parallel()) format.interpolation = Interpolation::affine;
    assert(view.width_px >= 0 && view.height_px >= 0);
    assert(view.camera.near > 0 && std::isfinite(view.camera.near));
    assert(format.halo_px >= 0 && format.halo_px <= kMaxHalo_px);
    assert(format.interpolants == 0 || input.values != nullptr);
    assert(!format.constant || input.constants.size() == input.mesh->surface().triangles.size());
    assert(input.constants_in_clusters.empty() ||
           input.constants_in_clusters.size() == input.mesh->clusters().triangle_ids.size());
    if (view.width_px == 0 || view.height_px == 0) return result;

    const TileGrid grid{view.width_px, view.height_px, format.halo_px};
    const std::vector<SolidView> solids = view_solids(input);
    const MeshJob job{format,
                      input,
                      grid,
                      ViewTransform(view),
                      solids,
                      front_to_back(input, solids),
                      lanes_can_draw(format),
                      LaneDepthBias(input.offset,
                                    QuantisedDepth(format.depth, view.camera.near, view.camera.far),
                                    format.depth)};
    std::vector<MeshRun>& runs = scratch_->runs;
    FrontDepth& front = scratch_->front;
    // In two goes where that pays: the nearest clusters and their pixels, then those of the others
    // that these do not hide.
    const std::size_t clusters = job.order.clusters.size();
    const std::size_t nearest = front_clusters(format, input, grid, job.solids);
    const std::size_t fronts = nearest == 0 ? 0 : run_count(nearest, input.threads);
    const std::size_t others = run_count(clusters - nearest, input.threads);
    runs.resize(fronts + others);
    const auto process = [&](std::size_t first, std::size_t end, MeshRun* run, std::size_t count) {
        const FrontDepth* seen = first == 0 ? nullptr : &front;
        core::parallel_for(count, input.threads, [&, run](std::size_t i) {
            run[i].process(job,
                           first + i * (end - first) / count,
                           first + (i + 1) * (end - first) / count,
                           seen);
        });
    };
    const auto for_each_tile = [&](const auto& visit) {
        std::atomic<int> next_tile = 0;
        std::vector<SkipCounts> shares(
            static_cast<std::size_t>(std::clamp(input.threads, 1, grid.count())));
        core::parallel_for(shares.size(), input.threads, [&](std::size_t i) {
            MeshTileWorker worker(job, runs, fronts, front);
            for (int tile = next_tile++; tile < grid.count(); tile = next_tile++)
                visit(worker, tile);
            shares[i] = worker.skips();
        });
        for (const SkipCounts& share : shares)
            add(result.skips, share);
    };
    if (fronts > 0) {
        front.start(grid, input);
        process(0, nearest, runs.data(), fronts);
        for_each_tile([](MeshTileWorker& worker, int tile) { worker.draw_front(tile); });
    }
    process(nearest, clusters, runs.data() + fronts, others);
    for (const MeshRun& run : runs)
        add(result.skips, run.skips());

    const auto tiles = static_cast<std::size_t>(grid.count());
    if (input.may_keep_still) {
        result.still.assign(tiles, 0);
        find_still_tiles(input, runs, scratch_->objects, result.still);
        SkipCount& count = count_of(result.skips, Skip::temporal_reuse);
        count.of = tiles;
        count.skipped = static_cast<std::uint64_t>(std::ranges::count(result.still, 1));
    } else {
        scratch_->objects.clear();
    }

    for_each_tile([&](MeshTileWorker& worker, int tile) {
        if (result.still.empty() || result.still[static_cast<std::size_t>(tile)] == 0)
            worker.draw(tile, sink);
    });
    return result;
}

}  // namespace ink::raster
