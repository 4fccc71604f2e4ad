#pragma once

#include <cstdint>
#include <filesystem>

#include "import/scene_stream.h"

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

}  // namespace ink::import
