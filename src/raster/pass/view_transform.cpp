#include "raster/pass/view_transform.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

namespace ink::raster {

ViewTransform::ViewTransform(const scene::View& view) {
    const scene::Camera& camera = view.camera;
    is_parallel = camera.is_parallel();
    const double focal_px = scene::Projection(view).px_per_world(1);
    const glm::dmat3 world_from_view = glm::transpose(camera.view_from_world);
    const glm::dvec3 right = world_from_view[0];
    const glm::dvec3 up = world_from_view[1];
    const glm::dvec3 back = world_from_view[2];
    center_px[0] = 0.5 * view.width_px;
    center_px[1] = 0.5 * view.height_px;
    for (int i = 0; i < 3; ++i) {
        eye[i] = camera.eye_world[i];
        rows[0][i] =
            is_parallel ? focal_px * right[i] : focal_px * right[i] - 0.5 * view.width_px * back[i];
        rows[1][i] =
            is_parallel ? -focal_px * up[i] : -focal_px * up[i] - 0.5 * view.height_px * back[i];
        rows[2][i] = -back[i];
    }
    near_plus_far = camera.near + camera.far;
    near_far = camera.near * camera.far;
}

std::optional<BallOnScreen> ViewTransform::see(const scene::Sphere& ball, double near) const {
    const glm::dvec3 p = to_clip(ball.center_world);
    const double radius = ball.radius * (1 + 1e-9);
    const double depth = is_parallel ? near_plus_far - near_far / p.z : p.z;
    if (!(depth - radius > near)) return std::nullopt;
    const auto q_at = [&](double at) {
        return is_parallel ? std::max((near_plus_far - at) / near_far, 0.0) : 1 / at;
    };
    BallOnScreen seen{{p.x / p.z, p.y / p.z}, {}, q_at(depth - radius), q_at(depth + radius)};
    // From the centre's pixel c, a point of the ball lies at (row - c w-row) . (its way) / w; of a
    // parallel camera, at row . (its way).
    for (int axis = 0; axis < 2; ++axis) {
        double sum = 0;
        for (int i = 0; i < 3; ++i) {
            const double v = rows[axis][i] - (is_parallel ? 0 : seen.center_px[axis] * rows[2][i]);
            sum += v * v;
        }
        seen.reach_px[axis] = radius * std::sqrt(sum) * (is_parallel ? 1 : seen.q_nearest);
    }
    return seen;
}

}  // namespace ink::raster
