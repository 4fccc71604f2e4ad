#pragma once

#include <memory>
#include <vector>

#include "import/scene_stream.h"

namespace ink::import {

/// Gives the scene the lights of its file as lamps that shine to all sides, and lets those go with
/// their nodes that move; `animation` is the scene's, null if nothing moves. Lights without light
/// are none.
///
/// A distant light becomes a lamp so far away that its rays are parallel. Strengths count by what
/// arrives in the scene's middle, and the brightest lamp of all has full light there. What else is
/// not as the file has it becomes a note in `scene.file`.
void take_lights(const std::vector<ImportedLight>& lights,
                 const std::shared_ptr<scene::Animation>& animation,
                 scene::Scene& scene);

}  // namespace ink::import
