#pragma once

#include <string>
#include <vector>

#include "parts.h"

namespace brep {

/// The bytes of a binary glTF file: a node and a mesh per part, hard edges marked by
/// EXT_mesh_primitive_edge_visibility, z up turned to y up.
[[nodiscard]] std::string glb_of(const std::vector<Part>& parts);

}  // namespace brep
