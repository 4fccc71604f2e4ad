#include "raster/lane_mesh.h"

#include <algorithm>

namespace ink::raster {
namespace {

constexpr std::size_t padded(std::size_t count) {
    return (count + kLanePad - 1) / kLanePad * kLanePad;
}

bool is_float(double v) {
    return static_cast<double>(static_cast<float>(v)) == v;
}

}  // namespace

LaneMesh::LaneMesh(const scene::Surface& surface)
    : surface_(&surface), clusters_(scene::make_clusters(surface)) {
    lay_out();
    fill();
}

void LaneMesh::update(const scene::Surface& moved) {
    surface_ = &moved;
    scene::refresh(moved, clusters_);
    lay_out();  // a triangle that gains an area joins the clusters
    fill();
}

void LaneMesh::lay_out() {
    first_vertex_.clear();
    first_triangle_.clear();
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    for (const scene::Cluster& cluster : clusters_.clusters) {
        first_vertex_.push_back(static_cast<std::uint32_t>(vertices));
        first_triangle_.push_back(static_cast<std::uint32_t>(triangles));
        vertices += padded(cluster.vertex_count);
        triangles += padded(cluster.triangle_count);
    }
    first_vertex_.push_back(static_cast<std::uint32_t>(vertices));
    for (std::size_t k = 0; k < 3; ++k) {
        corners_[k].resize(triangles);
        std::fill_n(corners_[k].data(), triangles, std::uint8_t{0});
        for (std::size_t c = 0; c < clusters_.clusters.size(); ++c) {
            const scene::Cluster& cluster = clusters_.clusters[c];
            for (std::size_t t = 0; t < cluster.triangle_count; ++t)
                corners_[k][first_triangle_[c] + t] =
                    clusters_.triangles[cluster.first_triangle + t][k];
        }
    }
}

void LaneMesh::fill() {
    const auto& positions = surface_->p_world;
    is_float_ = std::all_of(positions.begin(), positions.end(), [](const glm::dvec3& p) {
        return is_float(p.x) && is_float(p.y) && is_float(p.z);
    });
    const std::size_t count = first_vertex_.back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        floats_[axis].resize(is_float_ ? count : 0);
        doubles_[axis].resize(is_float_ ? 0 : count);
        normals_[axis].resize(surface_->n_world.empty() ? 0 : count);
    }
    for (std::size_t c = 0; c < clusters_.clusters.size(); ++c) {
        const scene::Cluster& cluster = clusters_.clusters[c];
        const std::size_t last = cluster.vertex_count - 1U;
        for (std::size_t i = first_vertex_[c]; i < first_vertex_[c + 1]; ++i) {
            const std::size_t local = std::min(i - first_vertex_[c], last);
            const std::size_t corner = clusters_.vertices[cluster.first_vertex + local];
            for (int axis = 0; axis < 3; ++axis) {
                const auto a = static_cast<std::size_t>(axis);
                if (is_float_) floats_[a][i] = static_cast<float>(positions[corner][axis]);
                if (!is_float_) doubles_[a][i] = positions[corner][axis];
                if (has_normals()) normals_[a][i] = surface_->n_world[corner][axis];
            }
        }
    }
}

}  // namespace ink::raster
