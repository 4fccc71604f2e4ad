#pragma once

#include <glm/vec3.hpp>

#include "scene/camera.h"

namespace ink::raster {

/// Takes world points to clip space (x, y, w), written out as one product, so that a lane of a
/// kernel and a plain loop do the same operations in the same order.
///
/// x/w and y/w are pixels, w the distance along the view direction, as with scene::Projection, from
/// which it differs by rounding in double only.
struct ViewTransform {
    double eye[3] = {};
    double rows[3][3] = {};  ///< x, y and w from the eye-relative world vector

    ViewTransform() = default;
    explicit ViewTransform(const scene::View& view);

    [[nodiscard]] glm::dvec3 to_clip(const glm::dvec3& p_world) const {
        const double x = p_world.x - eye[0];
        const double y = p_world.y - eye[1];
        const double z = p_world.z - eye[2];
        return {rows[0][0] * x + rows[0][1] * y + rows[0][2] * z,
                rows[1][0] * x + rows[1][1] * y + rows[1][2] * z,
                rows[2][0] * x + rows[2][1] * y + rows[2][2] * z};
    }
};

}  // namespace ink::raster
