#include "tests/inspect/compare_ids.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <vector>

#include "harness/truths/compare_truths.h"
#include "scene/surface.h"
#include "scene/topology.h"
#include "tests/raster/gather_sink.h"
#include "truth/eye_scene.h"

namespace ink::raster {
namespace {

constexpr double kNear_px = 1.0 / 256;
constexpr double kSteps = 4;

/// The corners of what lies beyond the near plane of a triangle, projected.
std::vector<glm::dvec2> visible_outline(const std::array<glm::dvec3, 3>& p_clip, double near) {
    std::vector<glm::dvec2> outline;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3& a = p_clip[i];
        const glm::dvec3& b = p_clip[(i + 1) % 3];
        if (a.z >= near) outline.emplace_back(a.x / a.z, a.y / a.z);
        if ((a.z >= near) != (b.z >= near)) {
            const glm::dvec3 cut = a + (b - a) * ((near - a.z) / (b.z - a.z));
            outline.emplace_back(cut.x / near, cut.y / near);
        }
    }
    return outline;
}

/// One view of a scene and its surface, and what can be asked of a triangle at a pixel centre.
class SeenSurface {
  public:
    SeenSurface(const scene::Scene& scene, const scene::View& view)
        : view_(view), projection_(view), surface_(scene::flatten(scene)) {
        for (const glm::dvec3& p : surface_.p_world)
            p_clip_.push_back(projection_.to_clip(p));
    }

    [[nodiscard]] const scene::Projection& projection() const { return projection_; }
    [[nodiscard]] core::Image<std::uint32_t> draw(DepthFormat depth) const {
        PassFormat format = id_format();
        format.depth = depth;
        std::vector<std::uint32_t> ids(surface_.triangles.size());
        std::iota(ids.begin(), ids.end(), 0U);
        PassInput input;
        input.p_clip = p_clip_;
        input.triangles = surface_.triangles;
        input.constants = ids;
        input.near = view_.camera.near;
        input.far = view_.camera.far;
        input.sky_code = {kNobody};
        return gathered<std::uint32_t, std::uint32_t>(
                   format, input, view_.width_px, view_.height_px)
            .planes[0];
    }
    [[nodiscard]] bool is_near_edge(std::uint32_t triangle, const glm::dvec2& p_px) const {
        if (triangle == kNobody) return false;
        const auto& [a, b, c] = surface_.triangles[triangle];
        return raster::is_near_edge({p_clip_[a], p_clip_[b], p_clip_[c]}, view_.camera.near, p_px);
    }
    /// 1/w of the triangle's plane along the pixel's ray.
    [[nodiscard]] double q(std::uint32_t triangle, const glm::dvec2& p_px) const {
        const auto& [a, b, c] = surface_.triangles[triangle];
        const auto& p = surface_.p_world;
        const glm::dvec3 normal = glm::cross(p[b] - p[a], p[c] - p[a]);
        const glm::dvec3 begin = projection_.ray_begin_world(p_px.x, p_px.y);
        const double along = glm::dot(normal, projection_.ray_world(p_px.x, p_px.y));
        return 1 / projection_.w_of(glm::dot(normal, p[a] - begin) / along);
    }
    /// About how much of itself the depth of a point of the triangle may be off when it is computed
    /// in
    /// floats from corners relative to the eye, as Embree does. Rounding moves corners and products
    /// by `eps * farthest`, and turns the normal by `eps * longest^2 / |normal|`, which moves the
    /// plane by `longest` times as much; a ray meets the moved plane 1/cos of the angle farther
    /// away or nearer.
    [[nodiscard]] double float_error(std::uint32_t triangle) const {
        constexpr double kRoundings = 4;
        glm::dvec3 p_eye[3];
        for (std::size_t i = 0; i < 3; ++i)
            p_eye[i] = surface_.p_world[surface_.triangles[triangle][i]] - projection_.eye_world();
        double farthest = 0;
        double longest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            farthest = std::max(farthest, glm::length(p_eye[i]));
            longest = std::max(longest, glm::length(p_eye[(i + 1) % 3] - p_eye[i]));
        }
        const glm::dvec3 normal = glm::cross(p_eye[1] - p_eye[0], p_eye[2] - p_eye[0]);
        const double area2 = glm::length(normal);
        const double moved = farthest + longest * longest * longest / area2;
        return kRoundings * std::numeric_limits<float>::epsilon() * moved * area2 /
               std::abs(glm::dot(normal, p_eye[0]));
    }

  private:
    const scene::View& view_;
    scene::Projection projection_;
    scene::Surface surface_;
    std::vector<glm::dvec3> p_clip_;
};

/// The size of one step of the depth format at 1/w = q, in 1/w.
double step_at(DepthFormat depth, double q, const scene::Camera& camera) {
    if (depth == DepthFormat::q32) {
        const auto rounded = static_cast<float>(q);
        return std::nextafter(rounded, std::numeric_limits<float>::infinity()) - rounded;
    }
    const double steps = depth == DepthFormat::z24 ? 16777215 : 65535;
    return (1 / camera.near - 1 / camera.far) / steps;
}

/// The global index of the triangle that Embree meets first.
class EmbreeIds {
  public:
    EmbreeIds(const scene::Scene& scene, const scene::View& view)
        : topology_(scene::weld(scene)),
          rays_(topology_, view.camera, 1),
          near_(view.camera.near) {}

    [[nodiscard]] std::uint32_t at(const scene::Projection& projection,
                                   const glm::dvec2& p_px) const {
        truth::EyeRay ray;
        ray.begin_world = projection.ray_begin_world(p_px.x, p_px.y);
        ray.way_world = projection.ray_world(p_px.x, p_px.y);
        ray.t_near = near_;
        ray.t_far = std::numeric_limits<double>::infinity();
        const auto hit = rays_.first(ray, [](std::uint32_t) { return true; });
        return hit ? topology_.faces[hit->face].triangle : kNobody;
    }

  private:
    scene::Topology topology_;
    truth::EyeScene rays_;
    double near_;
};

}  // namespace

bool is_near_edge(const std::array<glm::dvec3, 3>& p_clip, double near, const glm::dvec2& p_px) {
    const auto outline = visible_outline(p_clip, near);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if (harness::distance_to_segment(p_px, outline[i], outline[(i + 1) % outline.size()]) <=
            kNear_px)
            return true;
    }
    return false;
}

IdAgreement compare_ids(const scene::Scene& scene, const scene::View& view, DepthFormat depth) {
    const SeenSurface surface(scene, view);
    const EmbreeIds embree(scene, view);
    const auto ours = surface.draw(depth);
    IdAgreement result;
    for (int y = 0; y < view.height_px; ++y) {
        for (int x = 0; x < view.width_px; ++x) {
            const glm::dvec2 p_px(x + 0.5, y + 0.5);
            const std::uint32_t a = ours.at(x, y);
            const std::uint32_t b = embree.at(surface.projection(), p_px);
            if (a != kNobody || b != kNobody) ++result.covered;
            if (a == b) continue;
            if (surface.is_near_edge(a, p_px) || surface.is_near_edge(b, p_px)) {
                ++result.near_edge;
                continue;
            }
            const bool both = a != kNobody && b != kNobody;
            const double q_a = both ? surface.q(a, p_px) : 0;
            const double q_b = both ? surface.q(b, p_px) : 0;
            const double apart = std::abs(q_a - q_b);
            if (both && apart < kSteps * step_at(depth, q_a, view.camera)) {
                ++result.near_depth;
            } else if (both &&
                       apart < q_a * surface.float_error(a) + q_b * surface.float_error(b)) {
                ++result.in_floats;
            } else {
                ++result.other;
            }
        }
    }
    return result;
}

}  // namespace ink::raster
