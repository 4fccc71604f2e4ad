#include "scene/views/camera_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/error.h"
#include "core/hash.h"

namespace ink::scene {
namespace {

constexpr std::array kKinds = {PathKind::still,
                               PathKind::orbit,
                               PathKind::dolly,
                               PathKind::pan,
                               PathKind::shake,
                               PathKind::roll};

/// Cosine and sine without the last bits, in which machines differ, and of length 1 again.
glm::dvec2 turn(double angle_rad) {
    constexpr double kSteps = 1099511627776.0;  // 2^40
    const glm::dvec2 rounded{std::round(std::cos(angle_rad) * kSteps),
                             std::round(std::sin(angle_rad) * kSteps)};
    return rounded / std::sqrt(rounded.x * rounded.x + rounded.y * rounded.y);
}

/// The camera turned by `angle_rad` in the plane of axes `from` and `to` of its own view space: of
/// 0 and 2 to the right, of 1 and 2 upwards, of 0 and 1 rolled to the left.
void turn_in_view(Camera& camera, int from, int to, double angle_rad) {
    const glm::dvec2 t = turn(angle_rad);
    const glm::dmat3 world_from_view = glm::transpose(camera.view_from_world);
    glm::dmat3 turned = world_from_view;
    turned[from] = world_from_view[from] * t.x + world_from_view[to] * t.y;
    turned[to] = world_from_view[to] * t.x - world_from_view[from] * t.y;
    camera.view_from_world = glm::transpose(turned);
    camera.sight_world = {};
}

/// The whole camera turned about the vertical through `center_world`.
void orbit(Camera& camera, const glm::dvec3& center_world, double angle_rad) {
    const glm::dvec2 t = turn(angle_rad);
    const auto turned = [&](const glm::dvec3& v) {
        return glm::dvec3(v.x * t.x + v.z * t.y, v.y, v.z * t.x - v.x * t.y);
    };
    camera.eye_world = center_world + turned(camera.eye_world - center_world);
    glm::dmat3 world_from_view = glm::transpose(camera.view_from_world);
    for (int axis = 0; axis < 3; ++axis)
        world_from_view[axis] = turned(world_from_view[axis]);
    camera.view_from_world = glm::transpose(world_from_view);
    camera.sight_world = {};
}

double power(double base, int exponent) {
    double result = 1;
    for (int i = 0; i < exponent; ++i)
        result *= base;
    return result;
}

/// A parallel camera sees the same from everywhere: its height shrinks instead.
void dolly(Camera& camera, const Sphere& bounds, double growth) {
    camera.height_world /= growth;  // 0 of a pinhole stays
    if (camera.is_parallel()) return;
    const double depth = middle_depth(camera, bounds);
    const glm::dvec3 back_world = glm::transpose(camera.view_from_world)[2];
    camera.eye_world -= back_world * (depth - depth / growth);
}

/// A number of -1..1 for a frame and an axis of it.
double chance(std::uint64_t seed, int frame, int axis) {
    core::Hasher hasher;
    hasher.value(seed).value(frame).value(axis);
    return static_cast<double>(hasher.result() >> 11U) / 4503599627370496.0 - 1;  // 2^52
}

[[noreturn]] void refuse(PathKind kind, const std::string& what, const std::string& accepted) {
    throw core::Error(fmt::format("{} path", name(kind)), what, accepted);
}

/// The angle of an orbit that carries the ball's nearest point `step_px` across the image.
double orbit_turn_rad(const View& start, const Sphere& bounds, double step_px) {
    const glm::dvec3 out_world = start.camera.eye_world - bounds.center_world;
    const double distance = glm::length(out_world);
    const double gap = distance - bounds.radius;
    const double reach = std::sqrt(out_world.x * out_world.x + out_world.z * out_world.z);
    if (bounds.radius <= 0 || gap <= 0) {
        refuse(PathKind::orbit, "the eye is inside the scene's ball", "an eye outside");
    }
    if (reach <= 1e-6 * distance) {
        refuse(PathKind::orbit, "the eye is right above or below the scene", "an eye beside it");
    }
    const double arm = bounds.radius * reach / distance;  // of the nearest point, from the axis
    return step_px / (Projection(start).px_per_world(gap) * arm);
}

/// The angle that carries what is in the middle of the image `step_px` across it.
double pan_turn_rad(const View& start, const Sphere& bounds, double step_px) {
    const double depth = start.camera.is_parallel() ? middle_depth(start.camera, bounds) : 1;
    if (depth <= 0) refuse(PathKind::pan, "the scene lies behind the camera", "one before it");
    return std::atan(step_px / (Projection(start).focal_px() * depth));
}

}  // namespace

std::string_view name(PathKind kind) {
    static constexpr std::array<std::string_view, kKinds.size()> kNames = {
        "still", "orbit", "dolly", "pan", "shake", "roll"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::span<const PathKind> path_kinds() {
    return kKinds;
}

CameraPath make_path(PathKind kind, const View& start, const Sphere& bounds, double step_px) {
    if (!std::isfinite(step_px)) refuse(kind, "the step is not finite", "px a frame");
    if (start.height_px <= 0) refuse(kind, "the image has no height", "1 px or more");
    CameraPath path{.kind = kind, .start = start, .bounds = bounds};
    const double half_height_px = start.height_px / 2.0;
    switch (kind) {
        case PathKind::still:
            break;
        case PathKind::orbit:
            path.turn_rad = orbit_turn_rad(start, bounds, step_px);
            break;
        case PathKind::dolly:
            if (std::abs(step_px) >= half_height_px) {
                refuse(kind,
                       fmt::format("a step of {} px is too long", step_px),
                       fmt::format("less than {} px, half the height", half_height_px));
            }
            if (middle_depth(start.camera, bounds) <= 0) {
                refuse(kind, "the scene lies behind the camera", "a camera that looks at it");
            }
            path.growth = 1 + step_px / half_height_px;
            break;
        case PathKind::pan:
        case PathKind::shake:
            path.turn_rad = pan_turn_rad(start, bounds, step_px);
            break;
        case PathKind::roll:
            path.turn_rad = step_px / half_height_px;
            break;
    }
    return path;
}

PathFrame frame_at(const CameraPath& path, int frame) {
    assert(frame >= 0);
    PathFrame result{frame / path.frames_per_s, path.start};
    Camera& camera = result.view.camera;
    switch (path.kind) {
        case PathKind::still:
            break;
        case PathKind::orbit:
            orbit(camera, path.bounds.center_world, frame * path.turn_rad);
            break;
        case PathKind::dolly:
            dolly(camera, path.bounds, power(path.growth, frame));
            break;
        case PathKind::pan:
            turn_in_view(camera, 0, 2, frame * path.turn_rad);
            break;
        case PathKind::shake:
            turn_in_view(camera, 0, 2, chance(path.seed, frame, 0) * path.turn_rad);
            turn_in_view(camera, 1, 2, chance(path.seed, frame, 1) * path.turn_rad);
            break;
        case PathKind::roll:
            turn_in_view(camera, 0, 1, frame * path.turn_rad);
            break;
    }
    camera.name = fmt::format("{}_{:03}", name(path.kind), frame);
    Camera fitted = camera;
    fit_clip_range(fitted, path.bounds);
    camera.near = std::min(camera.near, fitted.near);
    camera.far = std::max(camera.far, fitted.far);
    return result;
}

}  // namespace ink::scene
