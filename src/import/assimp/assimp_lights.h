#pragma once

#include <assimp/scene.h>

#include <vector>

#include "import/assimp/assimp_nodes.h"
#include "import/scene_stream.h"

namespace ink::import {

/// The lights of a file, each with the node of its name. Their strengths are as the file has them,
/// their ranges in the world's units.
[[nodiscard]] std::vector<ImportedLight> convert_lights(const aiScene& scene,
                                                        const std::vector<PlacedNode>& nodes);

}  // namespace ink::import
