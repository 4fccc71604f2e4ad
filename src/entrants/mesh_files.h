#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <span>

#include "scene/scene.h"

namespace ink::entrants {

/// Writes the scene as it stands as Wavefront OBJ: world-space positions to the last digit, an `o`
/// per instance in the order of object ids, `usemtl material_N` per run of triangles of a material,
/// triangles in the order of global indices. No normals. Throws core::Error if it cannot be
/// written.
void write_obj(const scene::Scene& scene, const std::filesystem::path& path);

/// Writes the scene as it stands as binary glTF 2.0: a mesh per mesh with a primitive per material,
/// a node per instance with its matrix and `extras.object`, materials with `extras.material`.
/// Positions are the same floats; normals where the file had them. A camera per view, called by its
/// name. `base_colors` are colours and opacities by material number, 0..1; the rest are white.
/// `texcoords` are TEXCOORD_0 of each mesh as glTF has them, one per position or none. Throws
/// core::Error if it cannot be written, or needs more than the 4 GiB that the format holds.
void write_glb(const scene::Scene& scene,
               std::span<const scene::View> views,
               const std::filesystem::path& path,
               std::span<const glm::vec4> base_colors = {},
               std::span<const std::vector<glm::vec2>> texcoords = {});

}  // namespace ink::entrants
