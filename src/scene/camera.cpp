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

double radius_of(const Sphere& bounds) {
    return bounds.radius > 0 ? bounds.radius : 1.0;
}

constexpr double kLeastNear_radii = 1e-4;
constexpr double kFarOff_radii = 64;  ///< beyond it a camera's digits may show

/// From where a pinhole of 40 degrees would see as much as a parallel camera of that height.
double distance_of_pinhole(double height_world) {
    return height_world / (2 * std::tan(Camera{}.fov_y_rad / 2));
}

/// The depth at which a parallel camera that stands before a ball has its middle.
double standing_depth(const Camera& camera, const Sphere& bounds) {
    return std::max(2 * radius_of(bounds), distance_of_pinhole(camera.height_world));
}

bool is_before(const Camera& camera, const Sphere& bounds) {
    const double radius = radius_of(bounds);
    return middle_depth(camera, bounds) - radius >= kLeastNear_radii * radius;
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
    camera.sight_world = near_unit(view_direction);
    camera.fov_y_rad = fov_y_rad;
    return camera;
}

double middle_depth(const Camera& camera, const Sphere& bounds) {
    return -(camera.view_from_world * (bounds.center_world - camera.eye_world)).z;
}

void fit_clip_range(Camera& camera, const Sphere& bounds) {
    // Along the view direction, where depth is measured: a ball off to the side begins before
    // distance - radius.
    const double depth = middle_depth(camera, bounds), radius = radius_of(bounds);
    camera.near = std::max(depth - radius, kLeastNear_radii * radius);
    const double far = depth + radius;
    camera.far = far > camera.near ? far : 2 * camera.near;
}

void stand_before(Camera& camera, const Sphere& bounds) {
    if (!camera.is_parallel() || !is_before(camera, bounds)) return;
    const double nearer = middle_depth(camera, bounds) - standing_depth(camera, bounds);
    if (camera.near <= nearer) return;  // nothing is seen that is so near
    camera.eye_world += nearer * camera.viewpoint().at_world;
    camera.near -= nearer;
    camera.far -= nearer;
}

Camera parallel_camera(const ParallelLook& look, const Sphere& bounds) {
    const glm::dvec3 eye_world = look.target_world - look.way_world;
    Camera camera = look_at(eye_world, look.target_world, look.up_world, Camera{}.fov_y_rad);
    // Quotients are the same for all multiples of a direction; its length may be rounded otherwise.
    const glm::dvec3 size = glm::abs(look.way_world);
    const glm::dvec3 unit = look.way_world / std::max({size.x, size.y, size.z});
    camera.view_from_world =
        look_at(-unit, glm::dvec3(0), look.up_world, Camera{}.fov_y_rad).view_from_world;
    camera.sight_world = near_unit(look.way_world);
    camera.height_world = look.height_world;
    if (is_before(camera, bounds)) {
        // From the target, of which no digit depends on how far away the eye is.
        camera.eye_world = look.target_world;
        const double back = standing_depth(camera, bounds) - middle_depth(camera, bounds);
        camera.eye_world -= back * camera.viewpoint().at_world;
    }
    fit_clip_range(camera, bounds);
    return camera;
}

Camera projected(ProjectionKind kind, const Camera& camera, const Sphere& bounds) {
    if (kind == camera.projection()) return camera;
    const double depth =
        std::max(middle_depth(camera, bounds), std::max(bounds.radius, camera.near));
    Camera result = camera;
    if (kind == ProjectionKind::parallel) {
        result.height_world = 2 * depth * std::tan(camera.fov_y_rad / 2);
        // Beyond near + far it sees nothing.
        Camera fitted = result;
        fit_clip_range(fitted, bounds);
        result.far = std::max(result.far, fitted.far);
        if (depth > kFarOff_radii * radius_of(bounds)) stand_before(result, bounds);
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
    return is_parallel_ ? distance_of_pinhole(2 * center_px_.y / focal_px_) : 0;
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

View grown_view(const View& view, int more_px) {
    if (view.width_px <= 0 || view.height_px <= 0 || more_px == 0) return view;
    View grown = view;
    grown.width_px += more_px;
    grown.height_px += more_px;
    const double growth = static_cast<double>(grown.height_px) / view.height_px;
    grown.camera.fov_y_rad = 2 * std::atan(std::tan(view.camera.fov_y_rad / 2) * growth);
    grown.camera.height_world = view.camera.height_world * growth;
    return grown;
}

}  // namespace ink::scene
