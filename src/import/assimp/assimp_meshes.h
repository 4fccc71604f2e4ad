#pragma once

#include <assimp/scene.h>

#include <vector>

#include "import/assimp/assimp_nodes.h"
#include "import/scene_stream.h"

namespace ink::import {

[[nodiscard]] bool has_triangles(const aiMesh& mesh);

/// Adds an object for each node with triangles, of all its meshes. Nodes with the same meshes share
/// theirs; what has bones stands in world space, for each node anew.
void convert_meshes(const aiScene& scene,
                    const std::vector<PlacedNode>& nodes,
                    ImportReply& reply,
                    scene::Animation& motion);

}  // namespace ink::import
