#include "scene/views/corner_view.h"

#include <cmath>

namespace ink::scene {

View corner_view(const View& view) {
    if (view.width_px <= 0 || view.height_px <= 0) return view;
    View corners = view;
    ++corners.width_px;
    ++corners.height_px;
    const double growth = static_cast<double>(corners.height_px) / view.height_px;
    corners.camera.fov_y_rad = 2 * std::atan(std::tan(view.camera.fov_y_rad / 2) * growth);
    corners.camera.height_world = view.camera.height_world * growth;
    return corners;
}

}  // namespace ink::scene
