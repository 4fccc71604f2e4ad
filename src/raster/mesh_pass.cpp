#include "raster/mesh_pass.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <cmath>

#include "core/parallel.h"
#include "raster/coarse_depth.h"
#include "raster/flat_squares.h"
#include "raster/mesh_stage.h"
#include "raster/tile_buffer.h"
#include "raster/tile_fill.h"
#include "raster/whole_fill.h"

namespace ink::raster {
namespace {

SkipCount& count_of(SkipCounts& counts, Skip skip) {
    return counts[static_cast<std::size_t>(skip)];
}

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
    std::vector<std::uint64_t> objects;  ///< per tile, of the last frame
};

namespace {

/// What one thread needs to fill tiles.
class MeshTileWorker {
  public:
    MeshTileWorker(const MeshJob& job, const std::vector<MeshRun>& runs)
        : job_(job),
          runs_(runs),
          fill_(fill_function(job.format)),
          near_far_(make_input(job)),
          buffer_(job.format, near_far_, job.grid),
          proof_(job.format),
          tests_hidden_(job.input.skips.has(Skip::hidden) &&
                        job.format.depth == DepthFormat::q32) {}

    void draw(int tile, TileSink& sink) {
        const bool is_empty = std::all_of(
            runs_.begin(), runs_.end(), [&](const MeshRun& run) { return run.of(tile).empty(); });
        SkipCount& empty = count_of(skips_, Skip::empty_tiles);
        ++empty.of;
        const bool skips_empty = job_.input.skips.has(Skip::empty_tiles);
        if (!skips_empty) buffer_.touch();
        buffer_.start(tile);
        if (is_empty && skips_empty) {
            ++empty.skipped;
            buffer_.finish();
            sink.finish(buffer_.view(true));
            return;
        }
        std::uint16_t flat = 0;
        if (job_.input.flat_gives_zero && prove_flat(tile, flat)) {
            sink.finish(buffer_.view(true));
            return;
        }
        rects_ = needed_rects(buffer_, flat, job_.grid.halo_px);
        buffer_.touch();
        coarse_.start(buffer_);
        for (const MeshRun& run : runs_)
            draw_list(run, run.of(tile));
        buffer_.finish();
        buffer_.extend_frame();
        Tile finished = buffer_.view(false);
        finished.flat_squares = flat;
        sink.finish(finished);
    }

    [[nodiscard]] const SkipCounts& skips() const { return skips_; }

  private:
    static PassInput make_input(const MeshJob& job) {
        PassInput input;
        input.near = job.input.view.camera.near;
        input.far = job.input.view.camera.far;
        input.sky_f32 = job.input.sky_f32;
        input.sky_code = job.input.sky_code;
        return input;
    }

    /// Whether the whole tile lies inside one plane; else which of its squares do.
    bool prove_flat(int tile, std::uint16_t& flat) {
        const SkipSet& skips = job_.input.skips;
        const bool looks_at_tile = skips.has(Skip::flat_tiles);
        const bool looks_at_squares = skips.has(Skip::flat_stencils);
        SkipCount& tiles = count_of(skips_, Skip::flat_tiles);
        SkipCount& pixels = count_of(skips_, Skip::flat_stencils);
        const PixelRect& own = buffer_.own();
        ++tiles.of;
        pixels.of += static_cast<std::uint64_t>(own.x1 - own.x0) *
                     static_cast<std::uint64_t>(own.y1 - own.y0);
        if (!looks_at_tile && !looks_at_squares) return false;
        std::size_t count = 0;
        for (const MeshRun& run : runs_)
            count += run.of(tile).size();
        if (count == 0 || count > FlatProof::kMostTriangles) return false;
        proof_.start();
        for (const MeshRun& run : runs_) {
            for (const std::uint32_t entry : run.of(tile)) {
                if ((entry & kWholeTriangle) == 0) return false;
                proof_.add(run.whole_batches()->front(), entry & ~kWholeTriangle);
            }
        }
        const int halo = job_.grid.halo_px;
        const PixelRect wide{own.x0 - halo, own.y0 - halo, own.x1 + halo, own.y1 + halo};
        const PixelRect& drawn = buffer_.drawn();
        const bool is_inner = wide.x0 == drawn.x0 && wide.y0 == drawn.y0 && wide.x1 == drawn.x1 &&
                              wide.y1 == drawn.y1;
        if (looks_at_tile && is_inner && proof_.is_flat(wide)) {
            ++tiles.skipped;
            return true;
        }
        if (looks_at_squares) flat = proof_.flat_squares(buffer_, halo);
        constexpr std::uint64_t kArea = std::uint64_t{kFlatSquare_px} * kFlatSquare_px;
        pixels.skipped += kArea * static_cast<std::uint64_t>(std::popcount(flat));
        return false;
    }

    /// Triangles in order: stretches of one cluster for lanes, and whole ones by themselves.
    void draw_list(const MeshRun& run, std::span<const std::uint32_t> list) {
        const LaneSource source = run.source(*job_.input.mesh);
        SkipCount& hidden = count_of(skips_, Skip::hidden);
        hidden.of += list.size();
        while (!list.empty()) {
            const std::uint32_t slot = list[0] >> 8;
            std::size_t count = 1;
            if ((list[0] & kWholeTriangle) != 0) {
                draw_lanes(source);
                look_again(source);
                draw_whole(*run.whole_batches(), list[0] & ~kWholeTriangle);
            } else {
                while (count < list.size() && list[count] >> 8 == slot)
                    ++count;
                look_again(source);
                if (is_hidden(source.slots[slot].bounds, source.slots[slot].q_most)) {
                    hidden.skipped += count;
                } else {
                    coarse_.announce(count);
                    add_lanes(source, list.first(count));
                }
            }
            list = list.subspan(count);
        }
        draw_lanes(source);
    }

    /// Reads the coarse depth again if it is time: between clusters only, and with all before them
    /// drawn, so that what is found hidden does not hang on how clusters were shared out.
    void look_again(const LaneSource& source) {
        if (!tests_hidden_ || !coarse_.wants_refresh()) return;
        draw_lanes(source);
        coarse_.refresh();
    }

    [[nodiscard]] bool is_hidden(const PixelRect& bounds, float q_most) const {
        return tests_hidden_ && coarse_.hides(bounds, q_most);
    }

    /// Gathers triangles until there is a load for the lanes.
    void add_lanes(const LaneSource& source, std::span<const std::uint32_t> entries) {
        while (!entries.empty()) {
            const std::size_t count =
                std::min(entries.size(), LaneTriangles::kCount - lane_count_);
            std::copy_n(entries.begin(), count, lane_entries_.begin() + lane_count_);
            lane_count_ += count;
            entries = entries.subspan(count);
            if (lane_count_ == LaneTriangles::kCount) draw_lanes(source);
        }
    }

    void draw_lanes(const LaneSource& source) {
        if (lane_count_ == 0) return;
        const std::span<const std::uint32_t> entries(lane_entries_.data(), lane_count_);
        set_up_lanes(job_.format, source, entries, buffer_.drawn(), triangles_);
        fill_lanes(job_.format, triangles_, buffer_);
        lane_count_ = 0;
    }

    void draw_whole(const std::vector<Batch>& batches, std::uint32_t index) {
        const SetupTriangle& t = batches.front().triangles[index];
        if (is_hidden(t.bounds, static_cast<float>(t.q_max))) {
            ++count_of(skips_, Skip::hidden).skipped;
            return;
        }
        coarse_.announce(kWholeWeight);
        const BinEntry entry{0, index};
        const FillJob fill{job_.format, near_far_, batches};
        for (const PixelRect& rect : rects_) {
            if (!fill_whole(fill, entry, rect, buffer_)) {
                fill_(fill, {&entry, 1}, buffer_);
                break;
            }
        }
    }

    const MeshJob& job_;
    const std::vector<MeshRun>& runs_;
    FillTile fill_;
    PassInput near_far_;
    TileBuffer buffer_;
    LaneTriangles triangles_;
    std::array<std::uint32_t, LaneTriangles::kCount> lane_entries_{};
    std::size_t lane_count_ = 0;
    /// Whole triangles are large: one is worth this many small ones.
    static constexpr std::size_t kWholeWeight = 24;

    FlatProof proof_;
    std::vector<PixelRect> rects_;
    bool tests_hidden_;
    CoarseDepth coarse_;
    SkipCounts skips_{};
};

/// Runs of clusters: one on one thread, more on more, so that a slow one does not hold up all.
std::size_t run_count(std::size_t clusters, int threads) {
    constexpr std::size_t kRunsPerThread = 4;
    if (threads == 1) return 1;
    return std::clamp<std::size_t>(
        kRunsPerThread * static_cast<std::size_t>(threads), 1, std::max<std::size_t>(clusters, 1));
}

/// Marks the tiles that nothing which moved touches, now or in the last frame.
void find_still_tiles(const MeshInput& input,
                      const std::vector<MeshRun>& runs,
                      std::vector<std::uint64_t>& last,
                      std::vector<std::uint8_t>& still) {
    const bool has_last = last.size() == still.size();
    last.resize(still.size(), ~std::uint64_t{0});
    for (std::size_t tile = 0; tile < still.size(); ++tile) {
        std::uint64_t now = 0;
        for (const MeshRun& run : runs)
            now |= run.objects(static_cast<int>(tile));
        still[tile] = has_last && ((now | last[tile]) & input.moved_objects) == 0 ? 1 : 0;
        last[tile] = now;
    }
}

}  // namespace

MeshPass::MeshPass() : scratch_(std::make_unique<Scratch>()) {}
MeshPass::~MeshPass() = default;
MeshPass::MeshPass(MeshPass&&) noexcept = default;
MeshPass& MeshPass::operator=(MeshPass&&) noexcept = default;

MeshResult MeshPass::draw(const PassFormat& format, const MeshInput& input, TileSink& sink) {
    MeshResult result;
    const scene::View& view = input.view;
    assert(view.width_px >= 0 && view.height_px >= 0);
    assert(view.camera.near > 0 && std::isfinite(view.camera.near));
    assert(format.halo_px >= 0 && format.halo_px <= kMaxHalo_px);
    assert(format.interpolants == 0 || input.values != nullptr);
    if (view.width_px == 0 || view.height_px == 0) return result;

    const TileGrid grid{view.width_px, view.height_px, format.halo_px};
    const MeshJob job{
        format,
        input,
        grid,
        ViewTransform(view),
        view_solids(input),
        front_to_back(input),
        lanes_can_draw(format)};
    const std::size_t clusters = input.mesh->clusters().clusters.size();
    std::vector<MeshRun>& runs = scratch_->runs;
    runs.resize(run_count(clusters, input.threads));
    core::parallel_for(runs.size(), input.threads, [&](std::size_t i) {
        runs[i].process(job, i * clusters / runs.size(), (i + 1) * clusters / runs.size());
    });
    for (const MeshRun& run : runs)
        add(result.skips, run.skips());

    const auto tiles = static_cast<std::size_t>(grid.count());
    if (input.may_keep_still) {
        result.still.assign(tiles, 0);
        find_still_tiles(input, runs, scratch_->objects, result.still);
        SkipCount& count = count_of(result.skips, Skip::still_tiles);
        count.of = tiles;
        count.skipped =
            static_cast<std::uint64_t>(std::count(result.still.begin(), result.still.end(), 1));
    } else {
        scratch_->objects.clear();
    }

    std::atomic<int> next_tile = 0;
    std::vector<SkipCounts> shares(
        static_cast<std::size_t>(std::clamp(input.threads, 1, grid.count())));
    core::parallel_for(shares.size(), input.threads, [&](std::size_t i) {
        MeshTileWorker worker(job, runs);
        for (int tile = next_tile++; tile < grid.count(); tile = next_tile++) {
            if (!result.still.empty() && result.still[static_cast<std::size_t>(tile)] != 0)
                continue;
            worker.draw(tile, sink);
        }
        shares[i] = worker.skips();
    });
    for (const SkipCounts& share : shares)
        add(result.skips, share);
    return result;
}

}  // namespace ink::raster
