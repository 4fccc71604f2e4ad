#include "truth/trace_layers.h"

#include <algorithm>
#include <array>
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

constexpr int kBlock = 4;  ///< px: rays are cast in squares of 4 x 4

void fill_pixel(const EyeView& eye,
                const glm::dvec3& ray,
                const EyeScene::Hit& hit,
                std::size_t pixel,
                TracedLayers& out) {
    const std::uint32_t face = lowest(eye, ray, hit.face);
    out.face.data()[pixel] = face;
    out.layers.triangle.data()[pixel] = eye.model.topology.faces[face].triangle;
    out.layers.patch.data()[pixel] = eye.model.patch[face];
    float& w = out.layers.w.data()[pixel];
    w = static_cast<float>(hit.t);
    set_depth(eye, ray, face, w, out.layers.n_dot_v.data()[pixel]);
}

void trace_block(const EyeView& eye, const EyeScene& scene, int x_px, int y_px, TracedLayers& out) {
    const RayRange range{eye.near, std::numeric_limits<double>::infinity()};
    std::array<glm::dvec3, kBlock * kBlock> rays;
    std::uint32_t valid = 0;
    for (int i = 0; i < kBlock * kBlock; ++i) {
        const int x = x_px + i % kBlock, y = y_px + i / kBlock;
        rays[static_cast<std::size_t>(i)] = eye.projection.ray_world(x + 0.5, y + 0.5);
        if (out.face.contains(x, y)) valid |= 1U << i;
    }
    const auto hits = scene.first_of_sixteen(rays, range, valid);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (!hits[i]) continue;
        const auto x = static_cast<std::size_t>(x_px) + i % kBlock;
        const auto y = static_cast<std::size_t>(y_px) + i / kBlock;
        const std::size_t pixel = y * static_cast<std::size_t>(eye.width_px) + x;
        fill_pixel(eye, rays[i], *hits[i], pixel, out);
    }
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
    const auto rows = static_cast<std::size_t>((height + kBlock - 1) / kBlock);
    core::parallel_for(rows, threads, [&](std::size_t row) {
        for (int x = 0; x < width; x += kBlock)
            trace_block(eye, scene, x, static_cast<int>(row) * kBlock, out);
    });
    return out;
}

}  // namespace ink::truth
