#include "studies/hardest/view_space.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "core/error.h"
#include "scene/animation.h"
#include "scene/views/framing.h"

namespace ink::studies {
namespace {

constexpr int kBoxMoments = 8;  ///< of an animation, between which the box is not looked at

double lerp_log(double low, double high, double share) {
    return low * std::pow(high / low, share);
}

double share_log(double low, double high, double value) {
    return std::log(value / low) / std::log(high / low);
}

double in_unit(double x) {
    return std::clamp(x, 0.0, 1.0);
}

/// From so many radii away.
double most_fov_deg(double radii) {
    const double ball_deg = 2 * glm::degrees(std::asin(1 / radii));
    return std::min(kMostFov_deg, kMostFovOfBall * ball_deg);
}

/// `x` to so many decimals; with fewer than none to tens, hundreds and so on.
double to_decimals(double x, int decimals) {
    const double power = std::pow(10.0, std::abs(decimals));
    return decimals >= 0 ? std::round(x * power) / power : std::round(x / power) * power;
}

}  // namespace

harness::CameraRequest ViewChoice::camera() const {
    return {.eye_world = eye, .target_world = target, .fov_deg = fov_deg};
}

ViewSpace::ViewSpace(const scene::Scene& scene) : origin_(scene.origin) {
    const bool moves = scene.animation && scene.animation->duration_s > 0;
    if (moves) duration_s_ = scene.animation->duration_s;
    low_world_ = glm::dvec3(INFINITY);
    high_world_ = -low_world_;
    const auto hold = [&](const scene::Scene& posed) {
        for (const glm::dvec3& p_world : scene::placed_points(posed)) {
            low_world_ = glm::min(low_world_, p_world);
            high_world_ = glm::max(high_world_, p_world);
        }
    };
    hold(scene);
    if (moves) {
        scene::Scene posed = scene;
        for (int i = 0; i <= kBoxMoments; ++i) {
            scene::pose_scene(posed, *duration_s_ * i / kBoxMoments);
            hold(posed);
        }
    }
    ball_ = {(low_world_ + high_world_) / 2.0, glm::distance(low_world_, high_world_) / 2};
    if (ball_.radius > 0) return;
    throw core::Error(scene.name, "all its points are at one place", "a scene with an extent");
}

glm::dvec3 ViewSpace::rounded(const glm::dvec3& p_world) const {
    const int decimals = 4 - static_cast<int>(std::floor(std::log10(ball_.radius)));
    const glm::dvec3 p = p_world + origin_;
    return {to_decimals(p.x, decimals), to_decimals(p.y, decimals), to_decimals(p.z, decimals)};
}

ViewChoice ViewSpace::at(const std::vector<double>& point) const {
    const double azimuth_rad = 2 * std::numbers::pi * point[0];
    const double y = 2 * point[1] - 1;  // even over the ball
    const double across = std::sqrt(std::max(0.0, 1 - y * y));
    const glm::dvec3 to_eye(across * std::cos(azimuth_rad), y, across * std::sin(azimuth_rad));
    const double radii = lerp_log(kNearest_radii, kFarthest_radii, point[2]);
    ViewChoice choice;
    choice.eye = rounded(ball_.center_world + radii * ball_.radius * to_eye);
    choice.target =
        rounded(glm::mix(low_world_, high_world_, glm::dvec3(point[3], point[4], point[5])));
    choice.fov_deg = to_decimals(std::lerp(kLeastFov_deg, most_fov_deg(radii), point[6]), 1);
    if (duration_s_) {
        const double time_s = *duration_s_ * std::round(point[7] * kMoments) / kMoments;
        choice.time_s = std::floor(time_s * 1000) / 1000;
    }
    return choice;
}

std::vector<double> ViewSpace::point_of(const scene::Camera& camera) const {
    const glm::dvec3 from_center = camera.eye_world - ball_.center_world;
    const double distance = std::max(glm::length(from_center), 1e-9 * ball_.radius);
    const double radii = std::clamp(distance / ball_.radius, kNearest_radii, kFarthest_radii);
    const glm::dvec3 to_eye = from_center / distance;
    const glm::dvec3 ahead = -glm::dvec3(
        camera.view_from_world[0][2], camera.view_from_world[1][2], camera.view_from_world[2][2]);
    const glm::dvec3 target = camera.eye_world - glm::dot(from_center, ahead) * ahead;
    const glm::dvec3 extent = glm::max(high_world_ - low_world_, glm::dvec3(1e-300));
    const glm::dvec3 share = (target - low_world_) / extent;
    const double azimuth = std::atan2(to_eye.z, to_eye.x) / (2 * std::numbers::pi);
    std::vector<double> point = {azimuth < 0 ? azimuth + 1 : azimuth,
                                 in_unit((to_eye.y + 1) / 2),
                                 in_unit(share_log(kNearest_radii, kFarthest_radii, radii)),
                                 in_unit(share.x),
                                 in_unit(share.y),
                                 in_unit(share.z),
                                 in_unit((glm::degrees(camera.fov_y_rad) - kLeastFov_deg) /
                                         (most_fov_deg(radii) - kLeastFov_deg))};
    if (duration_s_) point.push_back(0);
    return point;
}

glm::dvec3 ViewSpace::direction(const ViewChoice& choice) const {
    return glm::normalize(choice.eye - origin_ - ball_.center_world);
}

}  // namespace ink::studies
