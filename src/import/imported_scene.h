#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "import/scene_stream.h"
#include "scene/scene.h"

namespace ink::import {

/// The checked scene in a reply of status `scene` that came from the model file at `path`: what
/// `import_scene` promises of names, normals, cameras and numbers holds afterwards.
///
/// With `material_seams` objects are split by material (scene::split_materials).
///
/// Throws Error with where = the path if the reply is inconsistent, holds no triangle or more than
/// `most_triangles` (each use of a mesh counted), or a number that is not finite or absurdly large.
[[nodiscard]] scene::Scene scene_from_reply(ImportReply&& reply,
                                            const std::filesystem::path& path,
                                            std::uint64_t most_triangles,
                                            bool material_seams = false);

/// Gives the scene the lights of its file as lamps that shine to all sides, and lets those go with
/// their nodes that move; `animation` is the scene's, null if nothing moves. Lights without light
/// are none.
///
/// A distant light becomes a lamp so far away that its rays are parallel. Strengths are told apart:
/// candela count by what arrives in the scene's middle, and the brightest lamp of all has full
/// light there; shares of full light stay as they are, unless one is above 1: then the brightest
/// has 1. What else is not as the file has it becomes a note in `scene.file`.
void take_lights(const std::vector<ImportedLight>& lights,
                 const std::shared_ptr<scene::Animation>& animation,
                 scene::Scene& scene);

/// Takes the place of a scene that lies far from its coordinates' zero out of all of them, and
/// returns what was taken: `origin` + a place in the reply is then that place in the file.
///
/// Along each axis on which the scene's middle is more than one and a half of its radii away, else
/// 0: each doubling of that distance takes a bit from what a float holds of the scene. What is
/// taken is a multiple of a power of two that is about the radius. Meshes that lie out there in
/// their own space are moved, and their instances and bones the other way; those that the file has
/// as floats only where these lose nothing by it. Indices must be good (see scene_from_reply).
[[nodiscard]] glm::dvec3 take_out_origin(ImportReply& reply);

/// The mesh with its positions as floats and a material per triangle. Its normals are as they come.
/// Takes `from` apart.
[[nodiscard]] scene::Mesh to_float_mesh(ImportedMesh&& from);

}  // namespace ink::import
