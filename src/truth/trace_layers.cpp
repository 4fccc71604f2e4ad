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
    const EyeView& eye, const scene::SightLine& ray, std::uint32_t f, float& w, float& cosine) {
    const scene::Topology& topology = eye.model.topology;
    const glm::dvec3 normal = topology.area_vector(f);
    const double along = glm::dot(normal, ray.way_world);
    // A triangle seen exactly edge-on, or thinner than its normal can tell, keeps what the ray
    // found.
    if (along == 0) return;
    w = static_cast<float>(
        glm::dot(normal, topology.p_world[topology.faces[f].vertices[0]] - ray.begin_world) /
        along);
    cosine =
        static_cast<float>(std::abs(along) / (glm::length(normal) * glm::length(ray.way_world)));
}

/// Whether the ray meets the closed triangle, which is not edge-on.
bool meets(const EyeView& eye, const scene::SightLine& ray, std::uint32_t f) {
    const auto& v = eye.model.topology.faces[f].vertices;
    const auto& p = eye.model.topology.p_world;
    const glm::dvec3 on_ray = ray.begin_world + ray.way_world;
    int low = 0, high = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const int s = scene::facing(on_ray, p[v[i]], p[v[(i + 1) % 3]], eye.eye());
        low = std::min(low, s);
        high = std::max(high, s);
    }
    return low == 0 || high == 0;
}

/// Of the faces that coincide with this one on the ray the lowest.
std::uint32_t lowest(const EyeView& eye, const scene::SightLine& ray, std::uint32_t face) {
    for (const CoplanarPair& pair : eye.model.crossings.coplanar_with(face)) {
        if (meets(eye, ray, pair.lower_face)) return pair.lower_face;
    }
    return face;
}

constexpr int kBlock = 4;  ///< px: rays are cast in squares of 4 x 4

/// Where the samples of a grid lie, and how many there are.
struct SampleGrid {
    int width = 0;
    int height = 0;
    double offset_px = 0;  ///< of sample (0, 0) from the image's top left corner, both ways
};

/// Casts a ray at every sample and calls found(ray, face, distance, sample) where it meets one.
template <class Found>
void trace_grid(const EyeView& eye,
                const EyeScene& scene,
                const SampleGrid& grid,
                int threads,
                const Found& found) {
    const RayRange range{eye.near, std::numeric_limits<double>::infinity()};
    const auto trace_block = [&](int x0, int y0) {
        std::array<scene::SightLine, kBlock * kBlock> rays;
        std::uint32_t valid = 0;
        for (int i = 0; i < kBlock * kBlock; ++i) {
            const int x = x0 + i % kBlock, y = y0 + i / kBlock;
            const double x_px = x + grid.offset_px, y_px = y + grid.offset_px;
            rays[static_cast<std::size_t>(i)] = {eye.projection.ray_begin_world(x_px, y_px),
                                                 eye.projection.ray_world(x_px, y_px)};
            if (x < grid.width && y < grid.height) valid |= 1U << i;
        }
        const auto hits = scene.first_of_sixteen(rays, range, valid);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            if (!hits[i]) continue;
            const auto x = static_cast<std::size_t>(x0) + i % kBlock;
            const auto y = static_cast<std::size_t>(y0) + i / kBlock;
            found(rays[i],
                  lowest(eye, rays[i], hits[i]->face),
                  hits[i]->t,
                  y * static_cast<std::size_t>(grid.width) + x);
        }
    };
    const auto rows = static_cast<std::size_t>((grid.height + kBlock - 1) / kBlock);
    core::parallel_for(rows, threads, [&](std::size_t row) {
        for (int x = 0; x < grid.width; x += kBlock)
            trace_block(x, static_cast<int>(row) * kBlock);
    });
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
    const auto fill =
        [&](const scene::SightLine& ray, std::uint32_t face, double t, std::size_t pixel) {
            out.face.data()[pixel] = face;
            out.layers.triangle.data()[pixel] = eye.model.topology.faces[face].triangle;
            out.layers.patch.data()[pixel] = eye.model.patch[face];
            float& w = out.layers.w.data()[pixel];
            w = static_cast<float>(t);
            set_depth(eye, ray, face, w, out.layers.n_dot_v.data()[pixel]);
        };
    trace_grid(eye, scene, {width, height, 0.5}, threads, fill);
    return out;
}

core::Image<std::uint32_t> trace_corners(const EyeView& eye, const EyeScene& scene, int threads) {
    const int width = eye.width_px + 1, height = eye.height_px + 1;
    core::Image<std::uint32_t> faces(width, height, kNoFace);
    trace_grid(eye,
               scene,
               {width, height, -kCornerShift_px},
               threads,
               [&](const scene::SightLine&, std::uint32_t face, double, std::size_t corner) {
                   faces.data()[corner] = face;
               });
    return faces;
}

}  // namespace ink::truth
