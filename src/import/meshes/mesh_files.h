#pragma once

#include <filesystem>
#include <optional>

#include "import/scene_stream.h"

namespace ink::import {

/// The model in a PLY, STL, OFF or OBJ file; nothing for other files. PLY, OFF and STL text are
/// told by content, whatever the file is called; binary STL and OBJ by their endings, as they have
/// no mark. A UTF-8 mark is read over, UTF-16 refused. Throws core::Error for a damaged file.
[[nodiscard]] std::optional<ImportReply> read_mesh_file(const std::filesystem::path& path);

}  // namespace ink::import
