#include "raster/mesh/mesh_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace ink::raster {

std::vector<SolidView> view_solids(const MeshInput& input) {
    const scene::Camera& camera = input.view.camera;
    const auto& solids = input.mesh->clusters().solids;
    std::vector<SolidView> views(solids.size());
    const auto depth_of = [&](const scene::Sphere& ball) {
        return -(camera.view_from_world * (ball.center_world - camera.eye_world)).z;
    };
    // A near plane fitted to the scene's own ball touches it at most, but for rounding.
    const bool is_all_uncut =
        input.bounds.radius > 0 &&
        depth_of(input.bounds) - input.bounds.radius >= camera.near - 1e-9 * input.bounds.radius;
    // A front hides the back behind it only if it is drawn, and neither is moved.
    const bool keeps_order = input.cull != Cull::front && !input.offset.is_any();
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const scene::Sphere& ball = solids[i].bounds;
        const glm::dvec3 way = ball.center_world - camera.eye_world;
        const double radius = ball.radius * (1 + 1e-6);
        const double depth = depth_of(ball);
        const bool is_uncut =
            is_all_uncut || depth - radius > camera.near || depth + radius < camera.near;
        views[i].hides_backs =
            keeps_order && solids[i].is_watertight && glm::length(way) > radius && is_uncut;
    }
    return views;
}

ClusterOrder front_to_back(const MeshInput& input, const std::vector<SolidView>& solids) {
    ClusterOrder result;
    constexpr std::size_t kSteps = 32;
    const auto& clusters = input.mesh->clusters().clusters;
    const glm::dvec3 eye = input.view.camera.eye_world;
    std::vector<double> distances(clusters.size());
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        const glm::dvec3 way = clusters[i].bounds.center_world - eye;
        distances[i] = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
    }
    std::vector<std::uint32_t>& order = result.clusters;
    order.resize(clusters.size());
    result.is_late.resize(clusters.size());
    if (order.empty()) return result;
    const auto [nearest, farthest] = std::minmax_element(distances.begin(), distances.end());
    const double origin = *nearest;
    const double scale = *farthest > origin ? (kSteps - 1) / (*farthest - origin) : 0;
    std::vector<std::uint8_t> steps(clusters.size());
    std::array<std::uint32_t, 2 * kSteps + 1> first{};
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        steps[i] = static_cast<std::uint8_t>((distances[i] - origin) * scale);
        // Where the solid hides its backs it is not drawn at all.
        const bool may_be_seen = !solids[clusters[i].solid].hides_backs;
        result.is_late[i] = may_be_seen && scene::is_turned_away(clusters[i], eye) ? 1 : 0;
        if (result.is_late[i] != 0) steps[i] = static_cast<std::uint8_t>(steps[i] + kSteps);
        ++first[steps[i] + 1U];
    }
    for (std::size_t step = 0; step + 1 < first.size(); ++step)
        first[step + 1] += first[step];
    for (std::size_t i = 0; i < clusters.size(); ++i)
        order[first[steps[i]]++] = static_cast<std::uint32_t>(i);
    return result;
}

ImageSides::ImageSides(const ViewTransform& transform, const scene::View& view)
    : transform_(transform),
      near_(view.camera.near),
      right_px_(view.width_px + 1.0),
      below_px_(view.height_px + 1.0) {
    const auto& rows = transform.rows;
    const auto length = [&](double kx, double ky, double kw) {
        double sum = 0;
        for (int i = 0; i < 3; ++i) {
            const double v = kx * rows[0][i] + ky * rows[1][i] + kw * rows[2][i];
            sum += v * v;
        }
        return std::sqrt(sum);
    };
    lengths_[0] = length(1, 0, 1);
    lengths_[1] = length(-1, 0, right_px_);
    lengths_[2] = length(0, 1, 1);
    lengths_[3] = length(0, -1, below_px_);
}

bool ImageSides::has_outside(const scene::Sphere& ball) const {
    const glm::dvec3 p = transform_.to_clip(ball.center_world);
    const double radius = ball.radius * (1 + 1e-9);
    return p.z < near_ - radius || p.x + p.z < -radius * lengths_[0] ||
           right_px_ * p.z - p.x < -radius * lengths_[1] || p.y + p.z < -radius * lengths_[2] ||
           below_px_ * p.z - p.y < -radius * lengths_[3];
}

}  // namespace ink::raster
