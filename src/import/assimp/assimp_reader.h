#pragma once

#include <filesystem>

#include "import/scene_stream.h"

namespace ink::import {

/// The model in any file that Assimp reads, and what moves in it: the keys of the chosen animation
/// and the bones of meshes. Of formats that store frames, Assimp shows the one with number `frame`
/// at most.
[[nodiscard]] ImportReply read_with_assimp(const std::filesystem::path& path,
                                           const ImportChoice& choice,
                                           int frame);

}  // namespace ink::import
