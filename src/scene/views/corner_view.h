#pragma once

#include "scene/camera.h"

namespace ink::scene {

/// The view whose pixel centres are the pixel corners of `view`.
///
/// The same camera with one column and one row more, the same focal length in px and the same
/// middle: the centre of its pixel (x, y) is the upper left corner of pixel (x, y) of `view`, (0,
/// 0) to (width_px, height_px). Only its angle, or height, grows, as it belongs to more rows. A
/// view without pixels has no corners and comes back as it is.
[[nodiscard]] View corner_view(const View& view);

}  // namespace ink::scene
