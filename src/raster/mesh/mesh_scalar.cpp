#include <algorithm>

#include "raster/mesh/mesh_stage.h"
#include "scene/predicates.h"

// The other way of a cluster: what lanes cannot draw, each triangle set up by itself.

namespace ink::raster {

void MeshRun::bin_scalar(const MeshJob& job, std::size_t from, std::uint64_t object) {
    for (std::size_t i = from; i < scalar().triangles.size(); ++i) {
        for_each_tile(job.grid, scalar().triangles[i], [&](std::size_t tile) {
            lists_[tile].push(kScalarTriangle | static_cast<std::uint32_t>(i));
            mark(tile, object);
        });
    }
}

/// One triangle after the other, each set up by itself: exact for any size and position.
void MeshRun::add_scalar(const MeshJob& job, std::size_t index, bool hides_backs) {
    const LaneMesh& mesh = *job.input.mesh;
    const scene::Clusters& clusters = mesh.clusters();
    const scene::Cluster& cluster = clusters.clusters[index];
    const scene::Surface& surface = mesh.surface();
    const scene::Camera& camera = job.input.view.camera;
    const bool drops = job.drops_backs(hides_backs);
    const bool drops_fronts = job.input.cull == Cull::front;

    cut_vertices_.p_clip.clear();
    cut_vertices_.n.clear();
    cut_vertices_.is_parallel = camera.is_parallel();
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
        const int side = scene::facing(p(0), p(1), p(2), camera.viewpoint());
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
        compute_scalar_values(job);
        input.values = values_[0];
        input.values_back = values_[1];
    }
    const std::size_t from = scalar().triangles.size();
    const std::uint64_t no_sample = scalar().no_sample;
    set_up_more(job.format, input, job.image(), scalar());
    SkipCount& count = count_of(skips_, Skip::no_sample);
    count.of += corners_.size();
    if (job.input.skips.has(Skip::no_sample)) count.skipped += scalar().no_sample - no_sample;
    if (job.input.offset.is_any()) bias_scalar(job, from);
    if (hides_backs && !drops) silence_backs(input, from);
    // From here on by their index in the surface: that is what a tile's fill finds constants by.
    for (std::size_t i = from; i < scalar().triangles.size(); ++i)
        scalar().triangles[i].triangle = ids[scalar().triangles[i].triangle];
    bin_scalar(job, from, job.object_bit(cluster));
}

/// Polygon offset.
void MeshRun::bias_scalar(const MeshJob& job, std::size_t from) {
    const scene::Camera& camera = job.input.view.camera;
    const OffsetRule rule(job.input.offset, job.format.depth, camera.near, camera.far);
    for (std::size_t i = from; i < scalar().triangles.size(); ++i)
        rule.apply(scalar().triangles[i]);
}

/// The same values as lanes would have, vertex by vertex, in the order that triangle_stage reads.
void MeshRun::compute_scalar_values(const MeshJob& job) {
    const std::size_t count = cut_vertices_.p_clip.size();
    const std::size_t room = (count + kLanePad - 1) / kLanePad * kLanePad;
    const auto planes = static_cast<std::size_t>(job.format.interpolants);
    scalar_w_.assign(2 * room, 1);
    scalar_n_.assign(3 * room, 0);
    scalar_planes_.assign(2 * planes * room, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const double w = std::max(cut_vertices_.p_clip[i].z, job.input.view.camera.near);
        scalar_w_[i] = w;
        scalar_w_[room + i] = 1 / w;
        for (std::size_t axis = 0; axis < 3; ++axis)
            scalar_n_[axis * room + i] = cut_vertices_.n[i][static_cast<int>(axis)];
    }
    CornerBatch in;
    in.count = count;
    in.w = scalar_w_.data();
    in.inv_w = scalar_w_.data() + room;
    CornerPlanes out;
    for (std::size_t axis = 0; axis < 3 && job.input.mesh->has_normals(); ++axis)
        in.n_world[axis] = scalar_n_.data() + axis * room;
    for (std::size_t k = 0; k < planes; ++k) {
        out.front[k] = scalar_planes_.data() + k * room;
        out.back[k] = scalar_planes_.data() + (planes + k) * room;
    }
    job.input.values->compute(in, out);
    for (std::size_t side = 0; side < 2; ++side) {
        values_[side].resize(count * planes);
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < planes; ++k)
                values_[side][i * planes + k] = scalar_planes_[(side * planes + k) * room + i];
        }
    }
}

/// Puts what a watertight solid hides at infinity: drawn, because nothing may be skipped, and
/// unseen.
void MeshRun::silence_backs(const PassInput& input, std::size_t from) {
    for (std::size_t i = from; i < scalar().triangles.size(); ++i) {
        SetupTriangle& t = scalar().triangles[i];
        if (input.facing[t.triangle] >= 0) continue;
        t.q = {};
        t.q_min = t.q_max = 0;
    }
}

}  // namespace ink::raster
