#pragma once

#include <string>
#include <string_view>

#include "import/meshes/polygons.h"
#include "import/scene_stream.h"

namespace ink::import {

/// The reply for a file that is one object: `mesh` without triangles yet, made of `faces`. Faces
/// without three corners are left out with a note.
[[nodiscard]] ImportReply reply_of_mesh(ImportedMesh mesh, const Polygons& faces);

/// What is said of materials that let light through.
[[nodiscard]] std::string drawn_opaque(std::size_t materials);

/// "1 line", "2 lines".
[[nodiscard]] std::string counted(std::size_t count, std::string_view what);

}  // namespace ink::import
