#pragma once

#include <assimp/scene.h>

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <unordered_map>
#include <vector>

#include "import/scene_stream.h"
#include "scene/animation.h"

namespace ink::import {

struct PlacedNode {
    const aiNode* node;
    glm::dmat4 world_from_node;
    std::uint32_t parent;  ///< in the same list
};

[[nodiscard]] glm::dvec3 to_glm(const aiVector3D& v);
/// The affine part of an Assimp matrix (which is row by row), in double.
[[nodiscard]] glm::dmat4 to_glm(const aiMatrix4x4& m);

/// All nodes, parents first, in the file's order.
[[nodiscard]] std::vector<PlacedNode> placed_nodes(const aiScene& scene);

/// Nodes by name, the first of each: so Assimp names bones and channels.
using NodeNumbers = std::unordered_map<std::string, std::uint32_t>;
[[nodiscard]] NodeNumbers numbers_of(const std::vector<PlacedNode>& nodes);

/// Adds the tree, and the keys of animation `chosen` on it, to `motion`.
void convert_motion(const aiScene& scene,
                    const std::vector<PlacedNode>& nodes,
                    std::size_t chosen,
                    scene::Animation& motion);

[[nodiscard]] bool has_triangles(const aiMesh& mesh);

/// Adds an object for each node with triangles, of all its meshes. Nodes with the same meshes share
/// theirs; what has bones stands in world space, for each node anew.
void convert_meshes(const aiScene& scene,
                    const std::vector<PlacedNode>& nodes,
                    ImportReply& reply,
                    scene::Animation& motion);

}  // namespace ink::import
