#include "raster/pass/view_transform.h"

#include <glm/matrix.hpp>

namespace ink::raster {

ViewTransform::ViewTransform(const scene::View& view) {
    const scene::Projection projection(view);
    const double focal_px = projection.focal_px();
    const glm::dmat3 world_from_view = glm::transpose(view.camera.view_from_world);
    const glm::dvec3 right = world_from_view[0];
    const glm::dvec3 up = world_from_view[1];
    const glm::dvec3 back = world_from_view[2];
    for (int i = 0; i < 3; ++i) {
        eye[i] = view.camera.eye_world[i];
        rows[0][i] = focal_px * right[i] - 0.5 * view.width_px * back[i];
        rows[1][i] = -focal_px * up[i] - 0.5 * view.height_px * back[i];
        rows[2][i] = -back[i];
    }
}

}  // namespace ink::raster
