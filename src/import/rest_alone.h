#pragma once

#include <string>
#include <vector>

#include "import/scene_stream.h"
#include "scene/scene.h"

// FBX is read at rest alone; motion comes from glTF.

namespace ink::import {

/// How to get the motion of a file that stands at rest.
inline constexpr const char* kMotionByGltf = "glTF, to which Blender 4 converts it";

/// Notes that a file with motion stands at rest. Throws Refusal if one of its animations was asked
/// for.
void note_rest_alone(const ModelChoice& choice, std::vector<std::string>& notes);

/// Whether a file has motion that was not read.
[[nodiscard]] bool is_at_rest_alone(const scene::FileFacts& file);

/// Throws Error about `option` if a file has motion that was not read.
void check_motion_is_read(const scene::Scene& scene, const std::string& option);

}  // namespace ink::import
