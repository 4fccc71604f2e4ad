#include "raster/mesh/mesh_pass.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "raster/depth/coarse_depth.h"
#include "raster/fragments/cluster_fragments.h"
#include "raster/mesh/front_depth.h"
#include "raster/mesh/lane_triangles.h"
#include "raster/mesh/mesh_stage.h"
#include "raster/pass/tile_buffer.h"
#include "raster/pass/tile_fill.h"

namespace ink::raster {
namespace {

void add(SkipCounts& to, const SkipCounts& from) {
    for (std::size_t i = 0; i < kSkipCount; ++i) {
        to[i].skipped += from[i].skipped;
        to[i].of += from[i].of;
    }
}

/// The depth of 1/w as the format has it.
float depth_of(const MeshJob& job, double q) {
    if (job.format.depth == DepthFormat::q32) return static_cast<float>(q);
    const scene::Camera& camera = job.input.view.camera;
    return static_cast<float>(QuantisedDepth(job.format.depth, camera.near, camera.far).of(q));
}

/// Triangles of the scalar path are large: one is worth this many small ones.
constexpr std::size_t kWholeWeight = 24;

/// What the buffers and the plain fill want to know of a frame.
PassInput make_input(const MeshJob& job) {
    PassInput input;
    input.near = job.input.view.camera.near;
    input.far = job.input.view.camera.far;
    input.sky_f32 = job.input.sky_f32;
    input.sky_code = job.input.sky_code;
    input.constants = job.input.constants;
    return input;
}

/// One thread's share of filling tiles: its buffers, used for tile after tile, and what it skipped.
class MeshTileWorker {
  public:
    /// All are borrowed. `fronts`: how many of the runs are of the nearest clusters and drawn
    /// first, into `front`; 0 where all are drawn in one go.
    MeshTileWorker(const MeshJob& job,
                   const std::vector<MeshRun>& runs,
                   std::size_t fronts,
                   FrontDepth& front);

    /// Draws the lists of the nearest clusters and puts the tile aside. Leaves it to draw() if
    /// there are none, or only triangles of the scalar path, of which the tile might be a flat one.
    void draw_front(int tile);

    /// Draws the tile's lists in the order of the runs, or finds that it need not, and hands it
    /// over.
    void draw(int tile, TileSink& sink);

    [[nodiscard]] const SkipCounts& skips() const { return skips_; }

  private:
    void finish(TileSink& sink);
    [[nodiscard]] bool list_scalar(int tile);
    [[nodiscard]] bool is_flat() const;
    void draw_list(const MeshRun& run, std::span<const std::uint32_t> list);
    void prefetch(const LaneSource& source, std::uint32_t entry) const;
    void look_again(const LaneSource& source, bool is_late);
    [[nodiscard]] bool is_hidden(const PixelRect& bounds, float q_most) const {
        return tests_hidden_ && coarse_.hides(bounds, q_most);
    }
    void add_lanes(const LaneSource& source, std::span<const std::uint32_t> entries);
    void draw_lanes(const LaneSource& source);
    void draw_fragments(const LaneSource& source, const LaneSlot& slot);
    std::size_t draw_stretch(const LaneSource& source, std::span<const std::uint32_t> list);
    void draw_scalar(const std::vector<Batch>& batches, std::uint32_t index);

    const MeshJob& job_;
    const std::vector<MeshRun>& runs_;
    std::size_t fronts_;
    FrontDepth& front_;
    bool is_late_ = false;  ///< all of the tile that faces the eye is drawn
    PassInput near_far_;
    TileBuffer buffer_;
    LaneTriangles triangles_;
    std::array<std::uint32_t, LaneTriangles::kCount> lane_entries_{};
    std::size_t lane_count_ = 0;
    FlatProof proof_;
    bool tests_hidden_;
    CoarseDepth coarse_;
    SkipCounts skips_{};
};

MeshTileWorker::MeshTileWorker(const MeshJob& job,
                               const std::vector<MeshRun>& runs,
                               std::size_t fronts,
                               FrontDepth& front)
    : job_(job),
      runs_(runs),
      fronts_(fronts),
      front_(front),
      near_far_(make_input(job)),
      buffer_(job.format, near_far_, job.grid),
      proof_(job.format),
      tests_hidden_(job.input.skips.has(Skip::occlusion_culling)),
      coarse_(job.format.depth) {}

void MeshTileWorker::draw_front(int tile) {
    const auto has_lanes = [tile](const MeshRun& run) {
        const auto list = run.of(tile);
        return std::ranges::any_of(list, [](std::uint32_t entry) { return !is_scalar(entry); });
    };
    const auto end = runs_.begin() + static_cast<std::ptrdiff_t>(fronts_);
    if (std::none_of(runs_.begin(), end, has_lanes)) return;
    buffer_.start(tile);
    buffer_.touch();
    coarse_.start(buffer_);
    is_late_ = false;
    for (auto run = runs_.begin(); run != end; ++run)
        draw_list(*run, run->of(tile));
    coarse_.refresh();
    FrontDepth::Tile& kept = front_.tile(tile);
    kept.least = coarse_.least();
    buffer_.put_aside(kept.pixels);
    kept.is_drawn = true;
}

void MeshTileWorker::draw(int tile, TileSink& sink) {
    if (fronts_ > 0 && front_.tile(tile).is_drawn) {
        buffer_.resume(tile, front_.tile(tile).pixels);
        ++count_of(skips_, Skip::empty_tiles).of;
        if (job_.input.flat_gives_zero) ++count_of(skips_, Skip::flat_tiles).of;
        coarse_.start(buffer_);
        coarse_.refresh();
        is_late_ = true;  // as good as that
        for (std::size_t i = fronts_; i < runs_.size(); ++i)
            draw_list(runs_[i], runs_[i].of(tile));
        finish(sink);
        return;
    }
    const bool is_empty =
        std::ranges::all_of(runs_, [&](const MeshRun& run) { return run.of(tile).empty(); });
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
    if (job_.input.flat_gives_zero) {
        SkipCount& flat = count_of(skips_, Skip::flat_tiles);
        ++flat.of;
        if (job_.input.skips.has(Skip::flat_tiles) && list_scalar(tile) && is_flat()) {
            ++flat.skipped;
            sink.finish(buffer_.view(true));
            return;
        }
    }
    buffer_.touch();
    coarse_.start(buffer_);
    is_late_ = false;
    for (const MeshRun& run : runs_)
        draw_list(run, run.of(tile));
    finish(sink);
}

void MeshTileWorker::finish(TileSink& sink) {
    buffer_.finish();
    buffer_.extend_frame();
    sink.finish(buffer_.view(false));
}

/// Gives the proof a tile's triangles, if they are few and all of them of the scalar path.
bool MeshTileWorker::list_scalar(int tile) {
    std::size_t count = 0;
    for (const MeshRun& run : runs_)
        count += run.of(tile).size();
    if (count == 0 || count > FlatProof::kMostTriangles) return false;
    proof_.start();
    for (const MeshRun& run : runs_) {
        for (const std::uint32_t entry : run.of(tile)) {
            if (!is_scalar(entry)) return false;
            proof_.add(run.scalar_batches()->front(), entry & ~kScalarTriangle);
        }
    }
    return true;
}

/// Whether the whole tile lies inside one plane.
bool MeshTileWorker::is_flat() const {
    return buffer_.is_inner() && proof_.is_flat(buffer_.drawn());
}

/// Triangles in order: stretches of one cluster for lanes, and those of the scalar path by
/// themselves.
void MeshTileWorker::draw_list(const MeshRun& run, std::span<const std::uint32_t> list) {
    const LaneSource source = run.source();
    while (!list.empty()) {
        std::size_t count = 1;
        if (is_scalar(list[0])) {
            ++count_of(skips_, Skip::occlusion_culling).of;
            draw_lanes(source);
            look_again(source, false);
            draw_scalar(*run.scalar_batches(), list[0] & ~kScalarTriangle);
        } else {
            count = draw_stretch(source, list);
        }
        list = list.subspan(count);
    }
    draw_lanes(source);
}

/// What the list has of its first slot; returns how many entries that is.
std::size_t MeshTileWorker::draw_stretch(const LaneSource& source,
                                         std::span<const std::uint32_t> list) {
    const std::uint32_t number = list[0] >> 8;
    const LaneSlot& slot = source.slots[number];
    std::size_t count = 1;
    while (count < list.size() && list[count] >> 8 == number)
        ++count;
    look_again(source, slot.is_late);
    constexpr std::size_t kAhead = 3;  // of fragments: each entry is a slot
    if (count + kAhead < list.size()) source.prefetch_slot(list[count + kAhead]);
    if (count < list.size()) prefetch(source, list[count]);
    const std::size_t triangles = is_fragments(list[0]) ? slot.triangles : count;
    SkipCount& hidden = count_of(skips_, Skip::occlusion_culling);
    hidden.of += triangles;
    if (is_hidden(slot.bounds, slot.q_most)) {
        hidden.skipped += triangles;
        return count;
    }
    coarse_.announce(triangles);
    is_fragments(list[0]) ? draw_fragments(source, slot) : add_lanes(source, list.first(count));
    return count;
}

/// Has what the next stretch reads on its way, unless it is hidden already.
void MeshTileWorker::prefetch(const LaneSource& source, std::uint32_t entry) const {
    if (is_scalar(entry)) return;
    const LaneSlot& slot = source.slots[entry >> 8];
    if (!is_hidden(slot.bounds, slot.q_most)) source.prefetch(slot);
}

/// Reads the coarse depth again if it is time, and before the first late cluster: between clusters
/// only, and with all before them drawn, so that what is found hidden does not depend on how
/// clusters were shared out.
void MeshTileWorker::look_again(const LaneSource& source, bool is_late) {
    const bool is_first_late = is_late && !is_late_;
    is_late_ = is_late_ || is_late;
    if (!tests_hidden_ || !(is_first_late || coarse_.wants_refresh())) return;
    draw_lanes(source);
    coarse_.refresh();
}

/// Gathers triangles until there is a load for the lanes.
void MeshTileWorker::add_lanes(const LaneSource& source, std::span<const std::uint32_t> entries) {
    while (!entries.empty()) {
        const std::size_t count = std::min(entries.size(), LaneTriangles::kCount - lane_count_);
        std::copy_n(entries.begin(), count, lane_entries_.begin() + lane_count_);
        lane_count_ += count;
        entries = entries.subspan(count);
        if (lane_count_ == LaneTriangles::kCount) draw_lanes(source);
    }
}

void MeshTileWorker::draw_lanes(const LaneSource& source) {
    if (lane_count_ == 0) return;
    const std::span<const std::uint32_t> entries(lane_entries_.data(), lane_count_);
    set_up_lanes(job_.format, source, entries, buffer_.drawn(), job_.depth_bias, triangles_);
    fill_lanes(job_.format, triangles_, buffer_);
    lane_count_ = 0;
}

void MeshTileWorker::draw_fragments(const LaneSource& source, const LaneSlot& slot) {
    draw_lanes(source);
    const FragmentBlock block(source.records + slot.first_byte, slot.fragments);
    fill_fragments(job_.format, block, slot.fragments, buffer_);
}

void MeshTileWorker::draw_scalar(const std::vector<Batch>& batches, std::uint32_t index) {
    const SetupTriangle& t = batches.front().triangles[index];
    if (is_hidden(t.bounds, depth_of(job_, t.q_max))) {
        ++count_of(skips_, Skip::occlusion_culling).skipped;
        return;
    }
    coarse_.announce(kWholeWeight);
    const BinEntry entry{0, index};
    const FillJob fill{job_.format, near_far_, batches};
    if (fill_triangle(fill, entry, buffer_)) return;
    buffer_.touch();
    fill_tile(fill, {&entry, 1}, buffer_);
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
