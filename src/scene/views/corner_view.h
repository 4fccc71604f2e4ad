#pragma once

#include "scene/camera.h"

namespace ink::scene {

/// The same camera with so many columns and rows more, half of them on either side: the same focal
/// length in px and the same middle. Only its angle, or height, grows, as it belongs to more rows.
/// A view without pixels comes back as it is.
[[nodiscard]] View grown_view(const View& view, int more_px);

/// The view whose pixel centres are the pixel corners of `view`: grown by one, so that the centre
/// of its pixel (x, y) is the upper left corner of pixel (x, y) of `view`, (0, 0) to (width_px,
/// height_px).
[[nodiscard]] inline View corner_view(const View& view) {
    return grown_view(view, 1);
}

}  // namespace ink::scene
