#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "import/fbx/models.h"

namespace ink::import {

/// Moves the points of a geometry by its blend shapes, each by its channel's DeformPercent. Between
/// the shapes of one channel the way is straight. Returns whether any point may have moved. Throws
/// core::Error for a damaged shape, Refusal for a percentage that has no such way.
bool add_blend_shapes(const FbxObject& geometry, std::vector<glm::dvec3>& points);

/// Where a skin takes each point of `model`'s geometry, as the bones stand; nothing without a skin.
/// Throws core::Error for a damaged skin, Refusal for one that does not blend linearly.
[[nodiscard]] std::optional<std::vector<glm::dmat4>> world_from_points(
    const FbxObject& geometry,
    const FbxModel& model,
    const std::vector<FbxModel>& models,
    std::size_t points);

}  // namespace ink::import
