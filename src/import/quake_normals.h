#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

namespace ink::import {

/// How many normals the vertices of MDL and MD2 files choose from.
inline constexpr std::size_t kQuakeNormals = 162;

/// Normal number `index` (below kQuakeNormals), unit to six digits, in the model's z-up axes.
[[nodiscard]] glm::vec3 quake_normal(std::size_t index);

}  // namespace ink::import
