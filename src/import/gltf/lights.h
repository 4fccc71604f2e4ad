#pragma once

#include <string>
#include <vector>

#include "import/gltf/document.h"
#include "import/gltf/tree.h"
#include "import/scene_stream.h"

namespace ink::import {

/// The lights of the scene's nodes that are not hidden (KHR_lights_punctual): strengths in candela
/// or lux, ranges as the file has them, for no node scales a light. Lights of a type that is not
/// known become a note.
[[nodiscard]] std::vector<ImportedLight> read_lights(const GltfDocument& document,
                                                     const GltfTree& tree,
                                                     std::vector<std::string>& notes);

}  // namespace ink::import
