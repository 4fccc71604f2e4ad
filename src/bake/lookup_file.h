#pragma once

#include <string>

#include "import/import.h"

namespace ink::bake {

/// What the shaders of surface_lookup and chords read of a glTF model, for a file beside its own.
///
/// Words of 32 bits, little-endian: how many faces, parts and points follow; eight words a face
/// (methods::LookupTable::Face); of a part, which one draw call draws, the file's node and the
/// primitive in the mesh there; of a point its part and the vertex. A point moves as that vertex
/// does. Throws core::Error for copies of a mesh in one node, and as methods::lookup_table().
[[nodiscard]] std::string lookup_file(const import::ImportedModel& model, double crease_deg);

}  // namespace ink::bake
