#include "scene/holes/remainder.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numeric>
#include <vector>

namespace ink::scene {
namespace {

/// Places of a solid, each in one of the groups that have been joined so far.
class Groups {
  public:
    explicit Groups(std::vector<std::uint32_t> places) : places_(std::move(places)) {
        std::sort(places_.begin(), places_.end());
        places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
        parents_.resize(places_.size());
        std::iota(parents_.begin(), parents_.end(), 0U);
    }
    [[nodiscard]] const std::vector<std::uint32_t>& places() const { return places_; }
    [[nodiscard]] std::uint32_t index_of(std::uint32_t place) const {
        const auto at = std::lower_bound(places_.begin(), places_.end(), place);
        return static_cast<std::uint32_t>(at - places_.begin());
    }
    std::uint32_t group_of(std::uint32_t index) {
        while (parents_[index] != index)
            index = parents_[index] = parents_[parents_[index]];
        return index;
    }
    void join(std::uint32_t a, std::uint32_t b) { parents_[group_of(a)] = group_of(b); }

  private:
    std::vector<std::uint32_t> places_;
    std::vector<std::uint32_t> parents_;
};

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
    const auto& all = clusters.clusters;
    const auto first = std::partition_point(
        all.begin(), all.end(), [&](const Cluster& cluster) { return cluster.solid < solid; });
    const auto end = std::partition_point(
        first, all.end(), [&](const Cluster& cluster) { return cluster.solid == solid; });
    return {first, end};
}

bool hangs_together_outside(const Surface& moved,
                            const Clusters& clusters,
                            std::uint32_t solid,
                            std::span<const Sphere> balls) {
    constexpr double kOutwards = 1 + 1e-9;
    const std::span<const Cluster> parts = clusters_of(clusters, solid);
    if (parts.empty()) return false;
    const auto first = clusters.places.begin();
    Groups groups({first + parts.front().first_vertex,
                   first + parts.back().first_vertex + parts.back().vertex_count});
    for (const Cluster& cluster : parts) {
        std::array<std::uint32_t, kMaxClusterVertices> indices;
        for (std::size_t v = 0; v < cluster.vertex_count; ++v)
            indices[v] = groups.index_of(clusters.places[cluster.first_vertex + v]);
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
    for (std::uint32_t i = 0; i < groups.places().size(); ++i) {
        const glm::dvec3& p = moved.p_world[groups.places()[i]];
        const bool is_inside = std::any_of(balls.begin(), balls.end(), [&](const Sphere& ball) {
            return square_of(p - ball.center_world) < ball.radius * ball.radius / kOutwards;
        });
        if (is_inside) continue;
        if (outside != ~0U && groups.group_of(i) != outside) return false;
        outside = groups.group_of(i);
    }
    return outside != ~0U;
}

}  // namespace ink::scene
