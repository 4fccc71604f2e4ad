#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "import/gltf/document.h"
#include "import/scene_stream.h"
#include "scene/animation.h"

namespace ink::import {

/// How a node lies in its parent: scaled, then turned, then moved.
struct GltfPlace {
    glm::dvec3 translation{0};
    glm::dquat rotation{1, 0, 0, 0};
    glm::dvec3 scale{1};
    [[nodiscard]] glm::dmat4 matrix() const;
};

/// The place that the members `translation`, `rotation` and `scale` of a node give.
[[nodiscard]] GltfPlace place_of(const JsonObject& node);

/// Fails unless `q` is about of length 1; returns it exactly so.
[[nodiscard]] glm::dquat unit_rotation(const glm::dquat& q, const JsonObject& owner);

/// `m` if it is affine, up to rounding, and then exactly so.
[[nodiscard]] glm::dmat4 affine_matrix(const std::vector<double>& m, const JsonObject& owner);

/// All nodes of the file, parents first, those of the scene before others. By its file's number
/// each has its place in the list.
struct GltfTree {
    std::vector<scene::AnimatedNode> nodes;
    std::vector<glm::dmat4> world_from_node;  ///< at rest, per node
    std::vector<std::size_t> in_scene;        ///< the file's numbers of the scene's nodes, in order
    std::vector<std::uint32_t> number_of;     ///< per node of the file: in `nodes`
    std::vector<bool> is_hidden;  ///< per node of the file: by KHR_node_visibility, above it too

    /// Hangs another node on one; returns its number.
    std::uint32_t add(std::uint32_t parent, const glm::dmat4& parent_from_node);
};

/// The tree of a document. Throws Error if it is none: several parents, a cycle, a scene's root
/// that is none. No recursion: a hostile tree is deep.
[[nodiscard]] GltfTree read_tree(const GltfDocument& document);

/// The lights of the scene's nodes that are not hidden (KHR_lights_punctual): strengths in candela
/// or lux, ranges as the file has them, for no node scales a light. Lights of a type that is not
/// known become a note.
[[nodiscard]] std::vector<ImportedLight> read_lights(const GltfDocument& document,
                                                     const GltfTree& tree,
                                                     std::vector<std::string>& notes);

}  // namespace ink::import
