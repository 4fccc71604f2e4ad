#pragma once

#include <glm/vec3.hpp>

#include "import/scene_stream.h"
#include "scene/scene.h"

namespace ink::import {

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
