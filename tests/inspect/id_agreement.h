#pragma once

#include <vector>

#include "scene/scene.h"

namespace ink::raster {

/// Expects no fault in any of the views, at pixel centres with q32 and z24 and at pixel corners
/// with q32, and prints both exceptions of each.
void expect_same_ids(const scene::Scene& scene, const std::vector<scene::Camera>& cameras);

/// `count` cameras round a scene for the image's shape that expect_same_ids uses.
[[nodiscard]] std::vector<scene::Camera> round_views(const scene::Scene& scene, int count);

}  // namespace ink::raster
