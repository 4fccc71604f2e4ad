#include "truth/trace_layers.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/parallel.h"
#include "scene/predicates.h"

namespace ink::truth {
namespace {

/// The distance at which the ray direction meets the face's plane, in double, and the cosine there.
void set_depth(
    const EyeView& eye, const glm::dvec3& ray, std::uint32_t f, float& w, float& cosine) {
    const auto& [a, b, c] = eye.model.topology.faces[f].vertices;
    const auto& p = eye.model.topology.p_world;
    const glm::dvec3 normal = glm::cross(p[b] - p[a], p[c] - p[a]);
    const double along = glm::dot(normal, ray);
    // A triangle seen exactly edge-on, or thinner than its normal can tell, keeps what the ray
    // found.
    if (along == 0) return;
    w = static_cast<float>(glm::dot(normal, p[a] - eye.eye_world()) / along);
    cosine = static_cast<float>(std::abs(along) / (glm::length(normal) * glm::length(ray)));
}

/// Whether the ray meets the closed triangle, which is not edge-on.
bool meets(const EyeView& eye, const glm::dvec3& ray, std::uint32_t f) {
    const auto& v = eye.model.topology.faces[f].vertices;
    const auto& p = eye.model.topology.p_world;
    const glm::dvec3 on_ray = eye.eye_world() + ray;
    int low = 0, high = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const int s = scene::orient3d(eye.eye_world(), on_ray, p[v[i]], p[v[(i + 1) % 3]]);
        low = std::min(low, s);
        high = std::max(high, s);
    }
    return low == 0 || high == 0;
}

/// Of the faces that coincide with this one on the ray the lowest.
std::uint32_t lowest(const EyeView& eye, const glm::dvec3& ray, std::uint32_t face) {
    for (const CoplanarPair& pair : eye.model.crossings.coplanar_with(face)) {
        if (meets(eye, ray, pair.lower_face)) return pair.lower_face;
    }
    return face;
}

}  // namespace

TracedLayers trace_layers(const EyeView& eye, const EyeScene& scene, int threads) {
    const int width = eye.width_px, height = eye.height_px;
    TracedLayers out;
    out.face = core::Image<std::uint32_t>(width, height, kNoFace);
    out.layers.triangle = core::Image<std::uint32_t>(width, height, kNoTriangle);
    out.layers.patch = core::Image<std::uint32_t>(width, height, kNoTriangle);
    out.layers.n_dot_v = core::Image<float>(width, height, 0);
    out.layers.w = core::Image<float>(width, height, std::numeric_limits<float>::infinity());
    const auto accept = [](std::uint32_t) { return true; };
    core::parallel_for(static_cast<std::size_t>(height), threads, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x) {
            EyeRay ray;
            ray.direction_world = eye.projection.ray_world(x + 0.5, y + 0.5);
            ray.t_near = eye.near;
            ray.t_far = std::numeric_limits<double>::infinity();
            const auto hit = scene.first(ray, accept);
            if (!hit) continue;
            const std::uint32_t face = lowest(eye, ray.direction_world, hit->face);
            out.face.at(x, y) = face;
            out.layers.triangle.at(x, y) = eye.model.topology.faces[face].triangle;
            out.layers.patch.at(x, y) = eye.model.patch[face];
            out.layers.w.at(x, y) = static_cast<float>(hit->t);
            set_depth(eye,
                      ray.direction_world,
                      face,
                      out.layers.w.at(x, y),
                      out.layers.n_dot_v.at(x, y));
        }
    });
    return out;
}

}  // namespace ink::truth
