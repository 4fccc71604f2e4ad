#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "import/fbx/document.h"

namespace ink::import {

/// A node of the scene, as it stands in the file, whatever its curves say.
struct FbxModel {
    const FbxObject* object = nullptr;
    glm::dmat4 world_from_model{1};
    glm::dmat4 model_from_mesh{1};  ///< geometric transform: moves its own meshes and nothing below
    bool is_hidden = false;         ///< Show or Visibility is 0, or hidden from above
    glm::dmat3 turn{1};             ///< its rotation and those above, without scales
    glm::dvec3 scale{1};            ///< its own
};

/// All models of the scene, parents first, in the file's order. Throws Refusal for a rotation that
/// is not read.
///
/// A model stands in its parent by T Roff Rp Rpre R Rpost^-1 Rp^-1 Soff Sp S Sp^-1, rotations in
/// degrees in the order that RotationOrder names; how it takes on the scales above it, InheritType
/// says ("Computing transformation matrices" in the documentation of Autodesk's FBX SDK).
[[nodiscard]] std::vector<FbxModel> read_fbx_models(const FbxDocument& document,
                                                    const glm::dmat4& world_from_file);

}  // namespace ink::import
