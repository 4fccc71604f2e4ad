#pragma once

#include <filesystem>
#include <optional>

#include "import/scene_stream.h"

namespace ink::import {

/// A refusal that names the format of a file that is known and not read, such as STEP: by its first
/// bytes where the format has a mark, else by the file's ending. Nothing for other files.
[[nodiscard]] std::optional<ImportReply> refuse_other_format(const std::filesystem::path& path);

}  // namespace ink::import
