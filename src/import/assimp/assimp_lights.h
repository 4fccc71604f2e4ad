#pragma once

#include <assimp/scene.h>

#include <vector>

#include "import/assimp/assimp_nodes.h"
#include "import/scene_stream.h"

namespace ink::import {

/// The lamps of the scene, each with the node of its name, as cameras are.
[[nodiscard]] std::vector<ImportedLight> convert_lights(const aiScene& scene,
                                                        const std::vector<PlacedNode>& nodes);

}  // namespace ink::import
