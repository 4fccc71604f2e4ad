#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"

namespace ink::core {

/// Why the system refused, for a message: "disk full (no space left on device)" for ENOSPC, else
/// the system's words for `error` with a small first letter; "unknown reason" for 0.
[[nodiscard]] std::string system_reason(int error);

/// A path that the file system refused to look up, to read or to write, as bad input.
[[nodiscard]] Error refused_path(const std::filesystem::filesystem_error& error);

/// The bytes of a file; nothing for what is no file, or cannot be read.
[[nodiscard]] std::optional<std::string> read_whole_file(const std::filesystem::path& path);

/// Writes `bytes` to a file beside `path` and renames it to `path`, so that nobody sees half of it,
/// also when several processes write the same file.
///
/// Throws Error (where = the path) if it cannot be written; nothing is left behind then, and an
/// older file of that name stays as it was.
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace ink::core
