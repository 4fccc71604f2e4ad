#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/param.h"
#include "raster/skips.h"
#include "scene/scene.h"

namespace ink::studies {

/// A scene that shows what skipping is worth: made by code, with one camera, 16:9.
struct SkipScene {
    std::string name;
    std::string summary;                 ///< one line: what there is to see, and to skip
    std::optional<raster::Skip> skip;    ///< the skip it was made for; none: one of the three views
    scene::Scene scene;                  ///< its camera has the scene's name
    core::ParamValues settings = {};     ///< for methods that know these keys
    std::vector<glm::dmat4> poses = {};  ///< of instance 0, frame by frame; none: nothing moves
};

/// The densest scene is a ball of 20 * 4^levels triangles, other dense ones have a 16th of them.
inline constexpr int kSkipSceneLevels = 8;

/// The scene on which `skip` has most to do. `levels` is 2..9: fewer make a lighter scene, whose
/// triangles are larger.
[[nodiscard]] SkipScene skip_scene(raster::Skip skip, int levels = kSkipSceneLevels);

/// One object of 20 * 4^(levels - 2) triangles from three places: behind the camera
/// (`view_empty`), far away (`view_small`) and so near that it fills the frame (`view_full`).
[[nodiscard]] std::vector<SkipScene> skip_views(int levels = kSkipSceneLevels);

}  // namespace ink::studies
