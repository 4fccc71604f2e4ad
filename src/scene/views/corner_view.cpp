#include "scene/views/corner_view.h"

#include <cmath>

namespace ink::scene {

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
