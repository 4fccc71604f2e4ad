#include "raster/mesh/mesh_stage.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstring>

#include "raster/mesh/lane_steps.h"
#include "scene/predicates.h"

namespace ink::raster {
namespace {

constexpr std::size_t kNumber = sizeof(float);

}  // namespace

std::size_t run_count(std::size_t clusters, int threads) {
    constexpr std::size_t kRunsPerThread = 4;
    if (threads == 1) return 1;
    return std::clamp<std::size_t>(
        kRunsPerThread * static_cast<std::size_t>(threads), 1, std::max<std::size_t>(clusters, 1));
}

void MeshRun::start(const MeshJob& job) {
    const auto tiles = static_cast<std::size_t>(job.grid.count());
    lists_.resize(tiles);
    for (EntryList& list : lists_)
        list.clear();
    objects_.assign(job.input.may_keep_still ? tiles : 0, 0);
    sides_ = ImageSides(job.transform, job.input.view);
    slots_.clear();
    records_.resize(0);
    scalar().triangles.clear();
    scalar().code_planes.clear();
    scalar().float_planes.clear();
    scalar().no_sample = 0;
    skips_ = {};
}

void MeshRun::process(const MeshJob& job,
                      std::size_t first,
                      std::size_t last,
                      const FrontDepth* front) {
    start(job);
    const LaneMesh& mesh = *job.input.mesh;
    shown_.clear();
    for (std::size_t i = first; i < last; ++i) {
        constexpr std::size_t kAhead = 24;
        if (i + kAhead < last) mesh.prefetch_bounds(job.order.clusters[i + kAhead]);
        if (may_show(job, job.order.clusters[i], front)) shown_.push_back(job.order.clusters[i]);
    }
    for (std::size_t i = 0; i < shown_.size(); ++i) {
        constexpr std::size_t kAhead = 4;
        if (i + kAhead < shown_.size()) mesh.prefetch_place(shown_[i + kAhead]);
        ahead_ = job.uses_lanes && i + 1 < shown_.size() ? shown_[i + 1] : kNone;
        add_cluster(job, shown_[i]);
    }
}

/// Whether a cluster lies in the image, is not turned away where that does not show, and is not
/// known to be hidden; counts what is not.
bool MeshRun::may_show(const MeshJob& job, std::size_t index, const FrontDepth* front) {
    const scene::Cluster& cluster = job.input.mesh->clusters().clusters[index];
    const SkipSet& skips = job.input.skips;
    SkipCount& frustum = count_of(skips_, Skip::frustum_culling);
    SkipCount& backs = count_of(skips_, Skip::back_face_culling);
    ++frustum.of;
    ++backs.of;
    if (skips.has(Skip::frustum_culling) && sides_.has_outside(cluster.bounds)) {
        ++frustum.skipped;
        return false;
    }
    if (job.drops_backs(job.hides_backs(index)) && skips.has(Skip::back_face_culling) &&
        scene::is_turned_away(cluster, job.input.view.camera.viewpoint())) {
        ++backs.skipped;
        return false;
    }
    if (front != nullptr && front->hides(cluster.bounds)) {
        SkipCount& hidden = count_of(skips_, Skip::occlusion_culling);
        hidden.of += cluster.triangle_count;
        hidden.skipped += cluster.triangle_count;
        return false;
    }
    return true;
}

void MeshRun::add_cluster(const MeshJob& job, std::size_t index) {
    const bool hides_backs = job.hides_backs(index);
    if (job.uses_lanes && add_in_lanes(job, index, hides_backs)) return;
    add_scalar(job, index, hides_backs);
}

/// Decides exactly which side the triangles show that culling and binning left open; drops those
/// whose side is of no use.
void MeshRun::settle_sides(const MeshJob& job, std::size_t index, const CullJob& cull) {
    const LaneMesh& mesh = *job.input.mesh;
    // From the last, so that those before keep their places.
    for (std::size_t i = culled_.unsure_count; i-- > 0;) {
        const std::size_t at = culled_.unsure[i];
        const std::uint32_t corners = culled_.corners[at];
        const auto p = [&](int k) { return mesh.position(index, corners >> 8 * k & 0xff); };
        const bool is_back = scene::facing(p(0), p(1), p(2), job.input.view.camera.viewpoint()) < 0;
        if (!(is_back ? cull.drops_backs : cull.drops_fronts)) {
            if (is_back) culled_.corners[at] |= kBackSide;
            culled_.has_back = culled_.has_back || is_back;
            continue;
        }
        const auto take_out = [&](auto* list) {
            std::copy(list + at + 1, list + culled_.count, list + at);
        };
        take_out(culled_.corners);
        take_out(culled_.x_span);
        take_out(culled_.y_span);
        --culled_.count;
    }
}

bool MeshRun::add_in_lanes(const MeshJob& job, std::size_t index, bool hides_backs) {
    const LaneMesh& mesh = *job.input.mesh;
    const scene::Cluster& cluster = mesh.clusters().clusters[index];
    const SkipSet& skips = job.input.skips;
    // Room for whatever is asked of it, and for the vectors that lookups read beyond.
    const std::size_t first_byte = records_.size();
    const std::size_t stride = lane_padded(cluster.vertex_count);
    constexpr std::size_t kMost =
        (LaneRecords::kMostArrays * scene::kMaxClusterVertices + 2 * CullResult::kCapacity) *
        kNumber;
    records_.reserve(first_byte + kMost);
    LaneRecords& records = lanes_.records;
    prefetch_ahead(job, 0);
    records = {records_.data() + first_byte, stride};
    if (!project_cluster(mesh, index, job.transform, job.input.view.camera.near, lanes_))
        return false;
    if (job.format.depth != DepthFormat::q32) {
        const scene::Camera& camera = job.input.view.camera;
        const QuantisedDepth depth(job.format.depth, camera.near, camera.far);
        const StepRange steps =
            make_steps(depth, lanes_.inv_w, cluster.vertex_count, lanes_.records.q());
        if (!lanes_can_step(depth, steps)) return false;
        lanes_.q_least = static_cast<float>(std::max(steps.least, 1.0));
        lanes_.q_most = static_cast<float>(std::max(steps.greatest, 1.0));
    }
    prefetch_ahead(job, 1);
    const CullJob cull{.image = job.image(),
                       .drops_backs = job.drops_backs(hides_backs),
                       .drops_fronts = job.input.cull == Cull::front,
                       .drops_no_sample = skips.has(Skip::no_sample)};
    cull_cluster(mesh, index, lanes_, cull, culled_);
    prefetch_ahead(job, 2);
    if (culled_.has_large) return false;
    SkipCount& no_sample = count_of(skips_, Skip::no_sample);
    no_sample.of += cluster.triangle_count;
    if (skips.has(Skip::no_sample)) no_sample.skipped += culled_.no_sample;
    settle_sides(job, index, cull);
    if (culled_.count == 0) return true;

    LaneSlot slot;
    const auto values = static_cast<std::size_t>(job.format.interpolants);
    std::size_t arrays = 3 + values;
    if (culled_.has_back && hides_backs) {  // drawn, because nothing may be skipped, and unseen
        std::fill_n(records.array(arrays), stride, 0.0F);
        slot.q[1] = static_cast<std::uint8_t>(arrays++);
    }
    const bool wants_back = values > 0 && culled_.has_back && !hides_backs;
    if (wants_back) {
        slot.values[1] = static_cast<std::uint8_t>(arrays);
        arrays += values;
    }
    if (!compute_values(job, index, slot)) return false;
    slot.stride = static_cast<std::uint32_t>(stride);
    slot.first_byte = first_byte;
    // A centre of a snapped triangle may lie 1/256 px outside the true one, which is at least 1.25
    // px high where q is not limited to its corners: q goes beyond them by less than this.
    slot.q_most =
        lanes_.q_most + (lanes_.q_most - lanes_.q_least) * 0x1p-6F + lanes_.q_most * 0x1p-20F;
    slot.bounds = {lanes_.x0 >> kSubpixelBits,
                   lanes_.y0 >> kSubpixelBits,
                   (lanes_.x1 >> kSubpixelBits) + 1,
                   (lanes_.y1 >> kSubpixelBits) + 1};
    slot.q_most = biased(job, slot.q_most);
    slot.is_late = job.order.is_late[index] != 0;
    if (makes_fragments(job, slot)) {
        add_fragments(job, index, slot);
        return true;
    }
    const std::size_t corners = arrays * stride;
    slot.corners = static_cast<std::uint8_t>(arrays);
    slot.constants = static_cast<std::uint32_t>(corners + lane_padded(culled_.count));
    records_.resize(keep_corners(job, index, first_byte + corners * kNumber));
    slot.byte_count = static_cast<std::uint32_t>(records_.size() - first_byte);
    slots_.push_back(slot);
    bin_lanes(job, slots_.size() - 1, job.object_bit(cluster));
    return true;
}

/// `q_most` of a cluster's triangles once they are moved.
float MeshRun::biased(const MeshJob& job, float q_most) const {
    if (!job.depth_bias.can_bias_nearer()) return q_most;
    const float depth_bias =
        most_depth_bias(job.depth_bias, lanes_.records, culled_.corners, culled_.count);
    return q_most + (depth_bias + depth_bias * 0x1p-20F);
}

/// Writes the corners of what culling and binning left, and their constants, from a byte of the
/// records on, where there is room; returns the byte behind them.
std::size_t MeshRun::keep_corners(const MeshJob& job, std::size_t index, std::size_t byte) {
    const std::size_t list_bytes = lane_padded(culled_.count) * kNumber;
    std::memcpy(records_.data() + byte, culled_.corners, culled_.count * kNumber);
    byte += list_bytes;
    if (!job.format.constant) return byte;
    list_constants(job, index, reinterpret_cast<std::uint32_t*>(records_.data() + byte));
    return byte + list_bytes;
}

/// The constants of what culling and binning left.
void MeshRun::list_constants(const MeshJob& job,
                             std::size_t index,
                             std::uint32_t* constants) const {
    const scene::Clusters& clusters = job.input.mesh->clusters();
    const std::uint32_t* ids =
        clusters.triangle_ids.data() + clusters.clusters[index].first_triangle;
    if (!job.input.constants_in_clusters.empty()) {
        const std::uint8_t* bytes =
            job.input.constants_in_clusters.data() + clusters.clusters[index].first_triangle;
        for (std::size_t i = 0; i < culled_.count; ++i)
            constants[i] = bytes[LaneMesh::index_of(culled_.corners[i])];
        return;
    }
    for (std::size_t i = 0; i < culled_.count; ++i)
        constants[i] = job.input.constants[ids[LaneMesh::index_of(culled_.corners[i])]];
}

/// The values of a cluster's vertices, one side or both. False if lanes cannot hold them.
bool MeshRun::compute_values(const MeshJob& job, std::size_t index, const LaneSlot& slot) {
    const auto values = static_cast<std::size_t>(job.format.interpolants);
    if (values == 0) return true;
    const LaneMesh& mesh = *job.input.mesh;
    const std::size_t vertices = mesh.clusters().clusters[index].vertex_count;
    const bool has_both = slot.values[1] != slot.values[0];
    CornerPlanes planes;
    for (std::size_t k = 0; k < values; ++k) {
        planes.front[k] = lanes_.records.array(slot.values[0] + k);
        if (has_both) planes.back[k] = lanes_.records.array(slot.values[1] + k);
    }
    job.input.values->compute(lanes_.batch(mesh, index), planes);
    for (std::size_t k = 0; k < values; ++k) {
        for (const float* plane : {planes.front[k], planes.back[k]}) {
            if (plane == nullptr) continue;
            const ValueRange range = range_of(plane, vertices);
            if (!lanes_can_hold(job.format, range.least, range.greatest)) return false;
        }
    }
    return true;
}

void MeshRun::bin_lanes(const MeshJob& job, std::size_t slot, std::uint64_t object) {
    const auto base = static_cast<std::uint32_t>(slot << 8);
    const TileRange tiles(job.grid, slots_[slot].bounds);
    tiles.for_each(job.grid, [&](int index) {
        const auto tile = static_cast<std::size_t>(index);
        if (tiles.is_one()) {  // as of most in a fine mesh
            list_all_triangles(culled_, base, lists_[tile]);
        } else if (list_triangles(culled_, job.grid.drawn(index), base, lists_[tile]) == 0) {
            return;
        }
        mark(tile, object);
    });
}

}  // namespace ink::raster
