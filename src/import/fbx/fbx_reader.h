#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "import/scene_stream.h"

namespace ink::import {

/// The model in an FBX file, text or binary, at rest; nothing for other files. Throws core::Error
/// for a damaged file, Refusal for what is known and not read.
[[nodiscard]] std::optional<ImportReply> read_fbx(const std::filesystem::path& path,
                                                  const ModelChoice& choice);

/// The same, of a file's bytes.
[[nodiscard]] ImportReply read_fbx_bytes(std::string_view file, const ModelChoice& choice);

}  // namespace ink::import
