#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "raster/skips.h"
#include "studies/axis.h"

namespace ink::studies {

/// The densest scene is a ball of 20 * 4^levels triangles, other dense ones have a 16th of them.
inline constexpr int kSkipSceneLevels = 8;

/// A scene that shows what skipping is worth.
struct SkipScene {
    /// The skip that has most to do on it; none: one of the three views.
    std::optional<raster::Skip> skip;
    /// Makes it by code: a case without a view, whose scene has one camera, 16:9, and its name.
    /// `levels` is 2..9: fewer make a lighter scene, whose triangles are larger.
    std::function<Case(int levels)> make;
};

/// One for each skip, in their order; then one object of 20 * 4^(levels - 2) triangles from three
/// places: behind the camera (`view_empty`), far away (`view_small`) and so near that it fills the
/// frame (`view_full`).
[[nodiscard]] const std::vector<SkipScene>& skip_scenes();

/// What skips are worth: an axis called skips_off for every scene of skip_scenes(), whose
/// values are 1: every skip is allowed; 2: all but that which the scene was made for (the three
/// views have none); 3: none. An image that a skip changes is a fault.
///
/// Where nothing moves, `temporal_reuse` is off at every value (skips_of_repeated_drawings).
/// Nothing is scored. Scenes are made of `levels` (SkipScene).
[[nodiscard]] std::vector<Axis> skip_axes(int levels = kSkipSceneLevels);

}  // namespace ink::studies
