#include "scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "core/error.h"
#include "scene/box.h"

namespace ink::scene {
namespace {

/// The axis least aligned with `direction`: a stand-in for an up vector that says nothing.
glm::dvec3 least_aligned_axis(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    if (size.x <= size.y && size.x <= size.z) return {1, 0, 0};
    return size.y <= size.z ? glm::dvec3{0, 1, 0} : glm::dvec3{0, 0, 1};
}

/// The same direction, exactly: times a power of two, so that its length is near 1 and its square
/// stays within the range of numbers. Zero stays zero.
glm::dvec3 near_unit(const glm::dvec3& v) {
    const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (most == 0) return v;
    const int down = -std::ilogb(most);
    return {std::scalbn(v.x, down), std::scalbn(v.y, down), std::scalbn(v.z, down)};
}

}  // namespace

Camera look_at(const glm::dvec3& eye_world,
               const glm::dvec3& target_world,
               const glm::dvec3& up_world,
               double fov_y_rad) {
    const glm::dvec3 view_direction = target_world - eye_world;
    const double distance = glm::length(view_direction);
    if (!is_finite(eye_world) || !is_finite(target_world) || !is_finite(up_world)) {
        throw core::Error("camera", "eye, target or up is not finite", "finite numbers");
    }
    if (!std::isfinite(distance) || distance == 0) {
        throw core::Error(
            "camera", "eye and target are the same point or too far apart", "two different points");
    }
    const glm::dvec3 back = view_direction / -distance;
    const glm::dvec3 up_near_unit = near_unit(up_world);
    glm::dvec3 right = glm::cross(up_near_unit, back);
    // Below this the direction of `right` is rounding noise, not the user's up.
    if (glm::length(right) <= 1e-9 * glm::length(up_near_unit)) {
        right = glm::cross(least_aligned_axis(back), back);
    }
    right = glm::normalize(right);
    const glm::dvec3 up = glm::cross(back, right);

    Camera camera;
    camera.eye_world = eye_world;
    camera.view_from_world = glm::transpose(glm::dmat3(right, up, back));
    camera.fov_y_rad = fov_y_rad;
    return camera;
}

void fit_clip_range(Camera& camera, const Sphere& bounds) {
    // Along the view direction, where depth is measured: a ball off to the side begins before
    // distance - radius.
    const glm::dvec3 center_view =
        camera.view_from_world * (bounds.center_world - camera.eye_world);
    const double radius = bounds.radius > 0 ? bounds.radius : 1.0;
    camera.near = std::max(-center_view.z - radius, 1e-4 * radius);
    const double far = -center_view.z + radius;
    camera.far = far > camera.near ? far : 2 * camera.near;
}

Camera projected(ProjectionKind kind, const Camera& camera, const Sphere& bounds) {
    if (kind == camera.projection()) return camera;
    const glm::dvec3 center_view =
        camera.view_from_world * (bounds.center_world - camera.eye_world);
    const double depth = std::max(-center_view.z, std::max(bounds.radius, camera.near));
    Camera result = camera;
    if (kind == ProjectionKind::parallel) {
        result.height_world = 2 * depth * std::tan(camera.fov_y_rad / 2);
        // Beyond near + far it sees nothing.
        Camera fitted = result;
        fit_clip_range(fitted, bounds);
        result.far = std::max(result.far, fitted.far);
    } else {
        constexpr double kRadPerDeg = std::numbers::pi / 180;
        result.height_world = 0;
        result.fov_y_rad = std::clamp(
            2 * std::atan(camera.height_world / (2 * depth)), kRadPerDeg, 170 * kRadPerDeg);
    }
    return result;
}

Projection::Projection(const View& view)
    : viewpoint_(view.camera.viewpoint()),
      eye_world_(view.camera.eye_world),
      view_from_world_(view.camera.view_from_world),
      is_parallel_(view.camera.is_parallel()),
      near_plus_far_(view.camera.near + view.camera.far),
      near_far_(view.camera.near * view.camera.far),
      focal_px_(is_parallel_ ? view.height_px / view.camera.height_world
                             : view.height_px / (2 * std::tan(view.camera.fov_y_rad / 2))),
      center_px_(view.width_px / 2.0, view.height_px / 2.0, 0) {}

double Projection::parallel_distance() const {
    const double height_world = 2 * center_px_.y / focal_px_;
    return is_parallel_ ? height_world / (2 * std::tan(Camera{}.fov_y_rad / 2)) : 0;
}

glm::dvec3 Projection::ray_world(double x_px, double y_px) const {
    if (is_parallel_) return viewpoint_.at_world;
    const glm::dvec3 d_view{
        (x_px - center_px_.x) / focal_px_, (center_px_.y - y_px) / focal_px_, -1};
    return glm::transpose(view_from_world_) * d_view;
}

glm::dvec3 Projection::ray_begin_world(double x_px, double y_px) const {
    if (!is_parallel_) return eye_world_;
    const glm::dvec3 p_view{
        (x_px - center_px_.x) / focal_px_, (center_px_.y - y_px) / focal_px_, 0};
    return eye_world_ + glm::transpose(view_from_world_) * p_view;
}

}  // namespace ink::scene
