#include "scene/holes/remainder.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "core/disjoint_sets.h"

namespace ink::scene {
namespace {

double square_of(const glm::dvec3& v) {
    return glm::dot(v, v);
}

/// The square of the distance to a triangle.
double square_to(const std::array<glm::dvec3, 3>& c, const glm::dvec3& p) {
    const glm::dvec3 n = glm::cross(c[1] - c[0], c[2] - c[0]);
    double least = square_of(p - c[0]);
    bool is_above = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 edge = c[(i + 1) % 3] - c[i];
        const glm::dvec3 arm = p - c[i];
        is_above = is_above && glm::dot(glm::cross(n, edge), arm) >= 0;
        const double t = std::clamp(glm::dot(arm, edge) / square_of(edge), 0.0, 1.0);
        least = std::min(least, square_of(arm - edge * t));
    }
    if (!is_above) return least;
    const double height = glm::dot(n, p - c[0]);
    return std::min(least, height * height / square_of(n));
}

}  // namespace

std::span<const Cluster> clusters_of(const Clusters& clusters, std::uint32_t solid) {
    return std::ranges::equal_range(clusters.clusters, solid, {}, &Cluster::solid);
}

bool hangs_together_outside(const Surface& moved,
                            const Clusters& clusters,
                            std::uint32_t solid,
                            std::span<const Sphere> balls) {
    constexpr double kOutwards = 1 + 1e-9;
    const std::span<const Cluster> parts = clusters_of(clusters, solid);
    if (parts.empty()) return false;
    const auto first = clusters.places.begin();
    std::vector<std::uint32_t> places(
        first + parts.front().first_vertex,
        first + parts.back().first_vertex + parts.back().vertex_count);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    core::DisjointSets groups(places.size());
    for (const Cluster& cluster : parts) {
        std::array<std::uint32_t, kMaxClusterVertices> indices;
        for (std::size_t v = 0; v < cluster.vertex_count; ++v)
            indices[v] = static_cast<std::uint32_t>(
                std::ranges::lower_bound(places, clusters.places[cluster.first_vertex + v]) -
                places.begin());
        const bool is_near = std::any_of(balls.begin(), balls.end(), [&](const Sphere& ball) {
            const double reach = (ball.radius + cluster.bounds.radius) * kOutwards;
            return square_of(cluster.bounds.center_world - ball.center_world) <= reach * reach;
        });
        for (std::size_t t = 0; t < cluster.triangle_count; ++t) {
            const auto& corners = clusters.triangles[cluster.first_triangle + t];
            std::array<glm::dvec3, 3> p;
            for (std::size_t i = 0; i < 3; ++i)
                p[i] = moved.p_world[clusters.vertices[cluster.first_vertex + corners[i]]];
            const auto meets = [&](const Sphere& ball) {
                const double radius = ball.radius * kOutwards;
                return !(square_to(p, ball.center_world) > radius * radius);
            };
            if (is_near && std::any_of(balls.begin(), balls.end(), meets)) continue;
            groups.join(indices[corners[0]], indices[corners[1]]);
            groups.join(indices[corners[0]], indices[corners[2]]);
        }
    }
    std::uint32_t outside = ~0U;
    for (std::uint32_t i = 0; i < places.size(); ++i) {
        const glm::dvec3& p = moved.p_world[places[i]];
        const bool is_inside = std::any_of(balls.begin(), balls.end(), [&](const Sphere& ball) {
            return square_of(p - ball.center_world) < ball.radius * ball.radius / kOutwards;
        });
        if (is_inside) continue;
        if (outside != ~0U && groups.root(i) != outside) return false;
        outside = groups.root(i);
    }
    return outside != ~0U;
}

}  // namespace ink::scene
