#include "raster/mesh/mesh_tiles.h"

#include <algorithm>

#include "raster/fragments/fragment_fill.h"
#include "raster/pass/tile_fill.h"

namespace ink::raster {
namespace {

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

}  // namespace

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

}  // namespace ink::raster
