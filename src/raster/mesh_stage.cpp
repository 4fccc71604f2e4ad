#include "raster/mesh_stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "raster/lane_steps.h"
#include "scene/predicates.h"

namespace ink::raster {
namespace {

PixelRect picture_of(const TileGrid& grid) {
    return {0, 0, grid.width_px, grid.height_px};
}

std::uint64_t object_bit(const MeshJob& job, const scene::Cluster& cluster) {
    return std::uint64_t{1} << (job.input.mesh->clusters().solids[cluster.solid].object % 64);
}

/// Whether triangles seen from their back are to be left out, for whichever reason.
bool drops_backs(const MeshJob& job, bool hides_backs) {
    return job.input.cull == Cull::back || (hides_backs && job.input.skips.has(Skip::backs));
}

}  // namespace

LaneSource MeshRun::source(const LaneMesh& mesh) const {
    return {&mesh, slots_.data(), records_.data(), more_.size() > 0 ? more_.data() : nullptr};
}

void MeshRun::start(const MeshJob& job) {
    const auto tiles = static_cast<std::size_t>(job.grid.count());
    lists_.resize(tiles);
    for (EntryList& list : lists_)
        list.clear();
    objects_.assign(job.input.may_keep_still ? tiles : 0, 0);
    slots_.clear();
    record_count_ = 0;
    records_.resize(0);
    more_.resize(0);
    whole().triangles.clear();
    whole().code_planes.clear();
    whole().float_planes.clear();
    whole().stats = {};
    skips_ = {};
}

void MeshRun::process(const MeshJob& job, std::size_t first, std::size_t last) {
    start(job);
    for (std::size_t cluster = first; cluster < last; ++cluster)
        add_cluster(job, job.order[cluster]);
}

void MeshRun::add_cluster(const MeshJob& job, std::size_t index) {
    const scene::Cluster& cluster = job.input.mesh->clusters().clusters[index];
    const SkipSet& skips = job.input.skips;
    SkipCount& frustum = count_of(skips_, Skip::frustum);
    SkipCount& backs = count_of(skips_, Skip::backs);
    ++frustum.of;
    ++backs.of;
    if (skips.has(Skip::frustum) && is_outside(cluster.bounds, job.transform, job.input.view)) {
        ++frustum.skipped;
        return;
    }
    const bool hides_backs = job.solids[cluster.solid].hides_backs;
    if (drops_backs(job, hides_backs) && skips.has(Skip::backs) &&
        scene::is_turned_away(cluster, job.input.view.camera.eye_world)) {
        ++backs.skipped;
        return;
    }
    if (job.uses_lanes && add_in_lanes(job, index, hides_backs)) return;
    add_whole(job, index, hides_backs);
}

/// Decides which side each triangle shows, exactly; drops those turned away that are of no use.
/// Returns whether any is left that shows its back.
bool MeshRun::settle_sides(const MeshJob& job, std::size_t index, bool hides_backs) {
    const scene::Surface& surface = job.input.mesh->surface();
    const scene::Clusters& clusters = job.input.mesh->clusters();
    const scene::Cluster& cluster = clusters.clusters[index];
    const bool drops = drops_backs(job, hides_backs);
    const bool drops_fronts = job.input.cull == Cull::front;
    bool has_back = false;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triage_.count; ++i) {
        std::int32_t side = -triage_.area[i];
        if (side == 0) {
            const auto& corners = clusters.triangles[cluster.first_triangle + triage_.triangle[i]];
            const auto p = [&](std::size_t k) {
                return surface.p_world[clusters.vertices[cluster.first_vertex + corners[k]]];
            };
            side = scene::facing(p(0), p(1), p(2), job.input.view.camera.eye_world);
        }
        const bool is_back = side < 0;
        if (is_back ? drops : drops_fronts) continue;
        has_back = has_back || is_back;
        triage_.triangle[kept] = triage_.triangle[i] | (is_back ? kBackSide : 0U);
        if (kept++ == i) continue;
        triage_.tile[kept - 1] = triage_.tile[i];
        triage_.x0[kept - 1] = triage_.x0[i];
        triage_.y0[kept - 1] = triage_.y0[i];
        triage_.x1[kept - 1] = triage_.x1[i];
        triage_.y1[kept - 1] = triage_.y1[i];
    }
    triage_.count = kept;
    return has_back;
}

/// Appends the cluster's vertices as one side has them.
std::uint32_t MeshRun::store_records(std::size_t count, int side, int values, bool is_silent) {
    const std::size_t first = record_count_;
    record_count_ += count;
    records_.resize((record_count_ + kLanePad) * kRecordWords);
    const auto& planes = lanes_.values[side];
    write_records(lanes_,
                  count,
                  values > 0 ? planes[0] : nullptr,
                  is_silent,
                  records_.data() + first * kRecordWords);
    if (values > 1) {
        more_.resize(record_count_ * kRecordWords);
        std::int32_t* to = more_.data() + first * kRecordWords;
        for (std::size_t i = 0; i < count; ++i, to += kRecordWords) {
            for (int k = 1; k < values; ++k)
                std::memcpy(to + k - 1, &planes[k][i], 4);
        }
    }
    return static_cast<std::uint32_t>(first);
}

bool MeshRun::add_in_lanes(const MeshJob& job, std::size_t index, bool hides_backs) {
    const LaneMesh& mesh = *job.input.mesh;
    const scene::Cluster& cluster = mesh.clusters().clusters[index];
    const SkipSet& skips = job.input.skips;
    if (!project_cluster(mesh, index, job.transform, job.input.view.camera.near, lanes_))
        return false;
    if (job.format.depth != DepthFormat::q32) {
        const scene::Camera& camera = job.input.view.camera;
        const QuantisedDepth depth(job.format.depth, camera.near, camera.far);
        const StepRange steps = make_steps(depth, lanes_.inv_w, cluster.vertex_count, lanes_.q);
        if (!lanes_can_step(depth, steps)) return false;
        lanes_.q_least = static_cast<float>(std::max(steps.least, 1.0));
        lanes_.q_most = static_cast<float>(std::max(steps.greatest, 1.0));
    }
    triage_cluster(mesh,
                   index,
                   lanes_,
                   {picture_of(job.grid),
                    job.grid.halo_px,
                    job.grid.columns(),
                    job.grid.rows(),
                    drops_backs(job, hides_backs),
                    skips.has(Skip::no_sample)},
                   triage_);
    if (triage_.has_large) return false;
    SkipCount& no_sample = count_of(skips_, Skip::no_sample);
    no_sample.of += cluster.triangle_count;
    if (skips.has(Skip::no_sample)) no_sample.skipped += triage_.no_sample;
    if (triage_.count == 0) return true;
    const bool has_back = settle_sides(job, index, hides_backs);
    if (triage_.count == 0) return true;

    const int values = job.format.interpolants;
    const bool wants_back = has_back && !hides_backs;
    if (values > 0) {
        job.input.values->compute(lanes_.batch(mesh, index), lanes_.planes(wants_back));
        for (int side = 0; side < (wants_back ? 2 : 1); ++side) {
            for (int k = 0; k < values; ++k) {
                const ValueRange range = range_of(lanes_.values[side][k], cluster.vertex_count);
                if (!lanes_can_hold(job.format, range.least, range.greatest)) return false;
            }
        }
    }
    LaneSlot slot;
    slot.cluster = static_cast<std::uint32_t>(index);
    // A centre of a snapped triangle may lie 1/256 px outside the true one, which is at least 1.25
    // px high where q is not limited to its corners: q goes beyond them by less than this.
    slot.q_most =
        lanes_.q_most + (lanes_.q_most - lanes_.q_least) * 0x1p-6F + lanes_.q_most * 0x1p-20F;
    slot.bounds = {lanes_.x0 >> kSubpixelBits,
                   lanes_.y0 >> kSubpixelBits,
                   (lanes_.x1 >> kSubpixelBits) + 1,
                   (lanes_.y1 >> kSubpixelBits) + 1};
    slot.front = store_records(cluster.vertex_count, 0, values, false);
    slot.back = slot.front;
    if (has_back)
        slot.back = store_records(cluster.vertex_count, wants_back ? 1 : 0, values, hides_backs);
    slots_.push_back(slot);
    bin_lanes(job, slots_.size() - 1, object_bit(job, cluster));
    return true;
}

void MeshRun::bin_lanes(const MeshJob& job, std::size_t slot, std::uint64_t object) {
    const TileGrid& grid = job.grid;
    const int halo = grid.halo_px;
    const auto base = static_cast<std::uint32_t>(slot << 8);
    const auto add = [&](std::size_t tile, std::size_t i) {
        lists_[tile].push(base | triage_.triangle[i]);
        if (!objects_.empty()) objects_[tile] |= object;
    };
    for (std::size_t i = 0; i < triage_.count; ++i) {
        if (triage_.tile[i] >= 0) {  // as most are
            add(static_cast<std::size_t>(triage_.tile[i]), i);
            continue;
        }
        const int column0 = std::max(triage_.x0[i] - halo, 0) / kTileSize_px;
        const int row0 = std::max(triage_.y0[i] - halo, 0) / kTileSize_px;
        const int column1 = std::min((triage_.x1[i] - 1 + halo) / kTileSize_px, grid.columns() - 1);
        const int row1 = std::min((triage_.y1[i] - 1 + halo) / kTileSize_px, grid.rows() - 1);
        for (int row = row0; row <= row1; ++row) {
            for (int column = column0; column <= column1; ++column)
                add(static_cast<std::size_t>(row * grid.columns() + column), i);
        }
    }
}

void MeshRun::bin_whole(const MeshJob& job, std::size_t from, std::uint64_t object) {
    for (std::size_t i = from; i < whole().triangles.size(); ++i) {
        for_each_tile(job.grid, whole().triangles[i], [&](std::size_t tile) {
            lists_[tile].push(kWholeTriangle | static_cast<std::uint32_t>(i));
            if (!objects_.empty()) objects_[tile] |= object;
        });
    }
}

/// One triangle after the other, each set up by itself: exact for any size and position.
void MeshRun::add_whole(const MeshJob& job, std::size_t index, bool hides_backs) {
    const LaneMesh& mesh = *job.input.mesh;
    const scene::Clusters& clusters = mesh.clusters();
    const scene::Cluster& cluster = clusters.clusters[index];
    const scene::Surface& surface = mesh.surface();
    const scene::Camera& camera = job.input.view.camera;
    const bool drops = drops_backs(job, hides_backs);
    const bool drops_fronts = job.input.cull == Cull::front;

    cut_vertices_.p_clip.clear();
    cut_vertices_.n.clear();
    bool is_whole = true;
    for (std::size_t i = 0; i < cluster.vertex_count; ++i) {
        const std::size_t corner = clusters.vertices[cluster.first_vertex + i];
        const glm::dvec3 p = job.transform.to_clip(surface.p_world[corner]);
        cut_vertices_.p_clip.push_back(p);
        cut_vertices_.n.push_back(mesh.has_normals() ? surface.n_world[corner] : glm::vec3(0));
        is_whole = is_whole && !needs_cut(p, camera.near);
    }
    corners_.clear();
    facing_.clear();
    triangle_ids_.clear();
    for (std::size_t t = 0; t < cluster.triangle_count; ++t) {
        const auto& c = clusters.triangles[cluster.first_triangle + t];
        const auto p = [&](std::size_t k) {
            return surface.p_world[clusters.vertices[cluster.first_vertex + c[k]]];
        };
        const int side = scene::facing(p(0), p(1), p(2), camera.eye_world);
        if (side < 0 ? drops : drops_fronts) continue;
        corners_.push_back({c[0], c[1], c[2]});
        facing_.push_back(static_cast<std::int8_t>(side));
        triangle_ids_.push_back(clusters.triangle_ids[cluster.first_triangle + t]);
    }
    PassInput input;
    input.triangles = corners_;
    input.facing = facing_;
    if (!is_whole) {
        cut_triangles(corners_, facing_, camera.near, cut_vertices_, cut_triangles_);
        input.triangles = cut_triangles_.triangles;
        input.facing = cut_triangles_.facing;
        for (std::uint32_t& source : cut_triangles_.source)
            source = triangle_ids_[source];
    }
    const std::vector<std::uint32_t>& ids = is_whole ? triangle_ids_ : cut_triangles_.source;
    if (job.format.constant) {
        constants_.clear();
        for (const std::uint32_t id : ids)
            constants_.push_back(job.input.constants[id]);
        input.constants = constants_;
    }
    input.p_clip = cut_vertices_.p_clip;
    input.near = camera.near;
    input.far = camera.far;
    if (job.format.interpolants > 0) {
        compute_whole_values(job);
        input.values = values_[0];
        input.values_back = values_[1];
    }
    const std::size_t from = whole().triangles.size();
    const std::uint64_t no_sample = whole().stats.triangles_no_sample;
    set_up_more(job.format, input, picture_of(job.grid), whole());
    SkipCount& count = count_of(skips_, Skip::no_sample);
    count.of += corners_.size();
    if (job.input.skips.has(Skip::no_sample))
        count.skipped += whole().stats.triangles_no_sample - no_sample;
    if (job.input.offset.is_any()) pull_whole(job, from);
    if (hides_backs && !drops) silence_backs(input, from);
    // From here on by their index in the surface: that is what a tile's fill finds constants by.
    for (std::size_t i = from; i < whole().triangles.size(); ++i)
        whole().triangles[i].triangle = ids[whole().triangles[i].triangle];
    bin_whole(job, from, object_bit(job, cluster));
}

/// Polygon offset.
void MeshRun::pull_whole(const MeshJob& job, std::size_t from) {
    const scene::Camera& camera = job.input.view.camera;
    const OffsetRule rule(job.input.offset, job.format.depth, camera.near, camera.far);
    for (std::size_t i = from; i < whole().triangles.size(); ++i)
        rule.apply(whole().triangles[i]);
}

/// The same values as lanes would have, vertex by vertex, in the order that triangle_stage reads.
void MeshRun::compute_whole_values(const MeshJob& job) {
    const std::size_t count = cut_vertices_.p_clip.size();
    const std::size_t room = (count + kLanePad - 1) / kLanePad * kLanePad;
    const auto planes = static_cast<std::size_t>(job.format.interpolants);
    whole_w_.assign(2 * room, 1);
    whole_n_.assign(3 * room, 0);
    whole_planes_.assign(2 * planes * room, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const double w = std::max(cut_vertices_.p_clip[i].z, job.input.view.camera.near);
        whole_w_[i] = w;
        whole_w_[room + i] = 1 / w;
        for (std::size_t axis = 0; axis < 3; ++axis)
            whole_n_[axis * room + i] = cut_vertices_.n[i][static_cast<int>(axis)];
    }
    CornerBatch in;
    in.count = count;
    in.w = whole_w_.data();
    in.inv_w = whole_w_.data() + room;
    CornerPlanes out;
    for (std::size_t axis = 0; axis < 3 && job.input.mesh->has_normals(); ++axis)
        in.n_world[axis] = whole_n_.data() + axis * room;
    for (std::size_t k = 0; k < planes; ++k) {
        out.front[k] = whole_planes_.data() + k * room;
        out.back[k] = whole_planes_.data() + (planes + k) * room;
    }
    job.input.values->compute(in, out);
    for (std::size_t side = 0; side < 2; ++side) {
        values_[side].resize(count * planes);
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < planes; ++k)
                values_[side][i * planes + k] = whole_planes_[(side * planes + k) * room + i];
        }
    }
}

/// Puts what a sealed solid hides at infinity: drawn, because nothing may be skipped, and unseen.
void MeshRun::silence_backs(const PassInput& input, std::size_t from) {
    for (std::size_t i = from; i < whole().triangles.size(); ++i) {
        SetupTriangle& t = whole().triangles[i];
        if (input.facing[t.triangle] >= 0) continue;
        t.q = {};
        t.q_min = t.q_max = 0;
    }
}

}  // namespace ink::raster
