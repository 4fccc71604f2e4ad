#include "crosscheck/plain_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/predicates.h"

namespace ink::crosscheck {
namespace {

constexpr double kExact_px = 1e-9;  ///< by so much double may miss on the way along a face

constexpr double kFarOff_px = 1e9;

/// Ascending by rows.
std::uint64_t key_of(double x_px, double y_px) {
    const auto part = [](double v) {
        return static_cast<std::uint64_t>(std::floor(std::clamp(v, -kFarOff_px, kFarOff_px)) +
                                          kFarOff_px);
    };
    return part(y_px) << 32U | part(x_px);
}

struct Box {
    glm::dvec2 low{-kFarOff_px}, high{kFarOff_px};
};

/// Where a face may be on the image; anywhere, if the near plane cuts it.
Box box_of(const ClipMesh& mesh, const scene::Face& face) {
    Box box{glm::dvec2(kFarOff_px), glm::dvec2(-kFarOff_px)};
    for (const std::uint32_t v : face.vertices) {
        const glm::dvec3& p = mesh.p_clip()[v];
        if (p.z < mesh.view().camera.near) return {};
        const glm::dvec2 at = glm::dvec2(p) / p.z;
        box.low = glm::min(box.low, at);
        box.high = glm::max(box.high, at);
    }
    return {box.low - PlainRays::kReach_px, box.high + PlainRays::kReach_px};
}

/// The distance along the view direction at which the ray, of unit depth, meets the face's plane.
double depth_of(const ClipMesh& mesh, const scene::Face& face, const glm::dvec3& ray) {
    const auto& p = mesh.topology().p_world;
    const auto& v = face.vertices;
    const glm::dvec3 eye = mesh.projection().eye_world();
    const glm::dvec3 n = glm::cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]);
    const double along = glm::dot(n, ray);
    return along != 0 ? glm::dot(n, p[v[0]] - eye) / along : 0;
}

}  // namespace

PlainRays::PlainRays(const ClipMesh& mesh, std::span<const glm::dvec2> places_px)
    : SightRays(mesh, kExact_px) {
    for (const glm::dvec2& p : places_px) {
        for (const double dx : {-kReach_px, kReach_px}) {
            for (const double dy : {-kReach_px, kReach_px})
                pixels_.push_back(key_of(p.x + dx, p.y + dy));
        }
    }
    std::sort(pixels_.begin(), pixels_.end());
    pixels_.erase(std::unique(pixels_.begin(), pixels_.end()), pixels_.end());
    faces_.resize(pixels_.size());
    if (pixels_.empty()) return;
    const auto& faces = mesh.topology().faces;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        const Box box = box_of(mesh, faces[f]);
        auto at = std::lower_bound(pixels_.begin(), pixels_.end(), key_of(box.low.x, box.low.y));
        const std::uint64_t last = key_of(box.high.x, box.high.y);
        const std::uint64_t left = key_of(box.low.x, 0) & 0xffffffffU;
        const std::uint64_t right = last & 0xffffffffU;
        while (at != pixels_.end() && *at <= last) {
            const std::uint64_t row = *at & ~std::uint64_t{0xffffffffU}, x = *at & 0xffffffffU;
            if (x < left) {
                at = std::lower_bound(at, pixels_.end(), row | left);
            } else if (x > right) {
                at = std::lower_bound(at, pixels_.end(), row + (std::uint64_t{1} << 32U) + left);
            } else {
                faces_[static_cast<std::size_t>(at - pixels_.begin())].push_back(f);
                ++at;
            }
        }
    }
}

bool PlainRays::is_met(std::uint32_t face, const glm::dvec3& ray) const {
    const auto& v = mesh().topology().faces[face].vertices;
    const auto& p = mesh().topology().p_world;
    const glm::dvec3 eye = mesh().projection().eye_world();
    // A point of the ray about as far off as the face: near the eye it would lie beside the ray.
    const double far = std::max(std::abs(mesh().p_clip()[v[0]].z), mesh().view().camera.near);
    const glm::dvec3 on_ray = eye + far * ray;
    int low = 0, high = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const int side = scene::orient3d(eye, on_ray, p[v[i]], p[v[(i + 1) % 3]]);
        low = std::min(low, side);
        high = std::max(high, side);
    }
    return low == 0 || high == 0;
}

std::span<const std::uint32_t> PlainRays::faces_near(const glm::dvec2& p_px) const {
    const std::uint64_t key = key_of(p_px.x, p_px.y);
    const auto at = std::lower_bound(pixels_.begin(), pixels_.end(), key);
    if (at == pixels_.end() || *at != key) return {};
    return faces_[static_cast<std::size_t>(at - pixels_.begin())];
}

Sight PlainRays::look(const glm::dvec2& p_px) const {
    const glm::dvec3 ray = mesh().projection().ray_world(p_px.x, p_px.y);
    Foremost foremost;
    for (const std::uint32_t face : faces_near(p_px)) {
        const double w = depth_of(mesh(), mesh().topology().faces[face], ray);
        if (w < mesh().view().camera.near || !foremost.may_take(w)) continue;
        if (is_met(face, ray)) foremost.add(mesh(), {face, w});
    }
    return foremost.seen();
}

}  // namespace ink::crosscheck
