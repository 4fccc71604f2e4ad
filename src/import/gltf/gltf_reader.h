#pragma once

#include <filesystem>
#include <optional>

#include "import/gltf/document.h"
#include "import/scene_stream.h"

namespace ink::import {

/// The model in a glTF 2.0 file, .gltf or .glb; nothing if the file is not glTF, by its content.
///
/// Throws Error that names the place in the file if anything in it is wrong, and Refusal if it
/// needs what is not read.
[[nodiscard]] std::optional<ImportReply> read_gltf(const std::filesystem::path& path,
                                                   const ModelChoice& choice);

/// As above, of a document that is open.
[[nodiscard]] ImportReply read_gltf(const GltfDocument& document, const ModelChoice& choice);

}  // namespace ink::import
