#include "raster/mesh/lane_mesh.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace ink::raster {
namespace {

bool is_float(double v) {
    return static_cast<double>(static_cast<float>(v)) == v;
}

}  // namespace

LaneMesh::LaneMesh(const scene::Surface& surface, scene::Clusters clusters)
    : surface_(&surface), clusters_(std::move(clusters)) {
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
    const auto& positions = surface_->p_world;
    is_float_ = std::ranges::all_of(positions, [](const glm::dvec3& p) {
        return is_float(p.x) && is_float(p.y) && is_float(p.z);
    });
    has_normals_ = !surface_->n_world.empty();
    const std::size_t vertex_bytes = (is_float_ ? 3 * sizeof(float) : 3 * sizeof(double)) +
                                     (has_normals_ ? 3 * sizeof(float) : 0);
    first_byte_.clear();
    std::size_t bytes = 0;
    for (const scene::Cluster& cluster : clusters_.clusters) {
        first_byte_.push_back(bytes);
        bytes += lane_padded(cluster.vertex_count) * vertex_bytes +
                 lane_padded(cluster.triangle_count) * sizeof(std::int32_t);
    }
    first_byte_.push_back(bytes);
    bytes_.resize(bytes);
    std::fill_n(bytes_.data(), bytes_.size(), std::byte{0});
}

void LaneMesh::fill() {
    for (std::size_t c = 0; c < clusters_.clusters.size(); ++c) {
        const scene::Cluster& cluster = clusters_.clusters[c];
        const std::size_t last = cluster.vertex_count - 1U;
        std::byte* to = bytes_.data() + first_byte_[c];
        const auto write = [&to](auto number) {
            std::memcpy(to, &number, sizeof number);
            to += sizeof number;
        };
        const auto for_each_vertex = [&](auto visit) {
            for (int axis = 0; axis < 3; ++axis) {
                for (std::size_t i = 0; i < padded(c); ++i)
                    visit(clusters_.vertices[cluster.first_vertex + std::min(i, last)], axis);
            }
        };
        for_each_vertex([&](std::size_t corner, int axis) {
            const double p = surface_->p_world[corner][axis];
            is_float_ ? write(static_cast<float>(p)) : write(p);
        });
        if (has_normals_) {
            for_each_vertex(
                [&](std::size_t corner, int axis) { write(surface_->n_world[corner][axis]); });
        }
        for (std::size_t t = 0; t < cluster.triangle_count; ++t) {
            const auto& corners = clusters_.triangles[cluster.first_triangle + t];
            write(static_cast<std::uint32_t>(corners[0] | corners[1] << 8 | corners[2] << 16 |
                                             t << 24));
        }
    }
}

}  // namespace ink::raster
