#pragma once

#include <string>
#include <vector>

#include "import/gltf/document.h"
#include "import/scene_stream.h"

namespace ink::import {

/// Throws Refusal, by name, if the file needs an extension that is not read. Notes those that it
/// uses, could be seen by, and are ignored.
void check_extensions(const GltfDocument& document, std::vector<std::string>& notes);

// The rest: what of a glTF file does not count, in words for ImportReply::notes.

/// The animations beside the one with number `animation`, and the scenes beside the one shown.
void note_choices(const GltfDocument& document,
                  std::size_t animation,
                  std::vector<std::string>& notes);

/// Primitives of points or lines, those of triangles without any, and channels of animation that
/// move no node.
void note_left_out(std::size_t lines,
                   std::size_t empty_parts,
                   std::size_t pointers,
                   std::vector<std::string>& notes);

/// Materials through which one would see.
void note_materials(const GltfDocument& document,
                    const std::vector<ImportedMesh>& meshes,
                    std::vector<std::string>& notes);

}  // namespace ink::import
