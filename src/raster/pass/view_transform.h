#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "scene/camera.h"

namespace ink::raster {

/// A ball on the screen, with room for rounding: its centre, how far it reaches from there, and the
/// least and greatest 1/w in it.
struct BallOnScreen {
    double center_px[2];
    double reach_px[2];
    double q_nearest;
    double q_farthest;
};

/// Takes world points to clip space (x, y, w), written out as one product, so that a lane of a
/// kernel and a plain loop do the same operations in the same order.
///
/// x/w and y/w are pixels, w is as scene::Projection has it, from which it differs by rounding in
/// double only.
struct ViewTransform {
    double eye[3] = {};
    double rows[3][3] = {};  ///< x, y and w from the eye-relative world vector
    bool is_parallel = false;
    /// Of a parallel camera, whose rows are pixels from the centre, and the depth.
    double center_px[2] = {};
    double near_plus_far = 0;
    double near_far = 0;

    ViewTransform() = default;
    explicit ViewTransform(const scene::View& view);

    [[nodiscard]] glm::dvec3 to_clip(const glm::dvec3& p_world) const {
        const glm::dvec3 p = by_rows(p_world);
        if (!is_parallel) return p;
        const double w = near_far / (near_plus_far - p.z);
        return {(p.x + center_px[0]) * w, (p.y + center_px[1]) * w, w};
    }
    /// The distance along the view direction.
    [[nodiscard]] double depth(const glm::dvec3& p_world) const { return by_rows(p_world).z; }

    /// Nothing if the ball reaches the near plane.
    [[nodiscard]] std::optional<BallOnScreen> see(const scene::Sphere& ball, double near) const;

  private:
    [[nodiscard]] glm::dvec3 by_rows(const glm::dvec3& p_world) const {
        const double x = p_world.x - eye[0];
        const double y = p_world.y - eye[1];
        const double z = p_world.z - eye[2];
        return {rows[0][0] * x + rows[0][1] * y + rows[0][2] * z,
                rows[1][0] * x + rows[1][1] * y + rows[1][2] * z,
                rows[2][0] * x + rows[2][1] * y + rows[2][2] * z};
    }
};

}  // namespace ink::raster
