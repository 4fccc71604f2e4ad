#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace ink::bake {

/// Gives normals to the meshes that have none: those of smooth patches, which creases part. A
/// vertex that has several is copied, with its own of the meshes' `texcoords`, if any; triangles
/// and their corners keep their order. For a scene that is not to move.
void add_normals(scene::Scene& scene,
                 double crease_deg,
                 std::span<std::vector<glm::vec2>> texcoords = {});

}  // namespace ink::bake
