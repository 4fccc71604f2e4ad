#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ink::core {

/// The bytes of a file; nothing for what is no file, or cannot be read.
[[nodiscard]] std::optional<std::string> read_whole_file(const std::filesystem::path& path);

/// Writes `bytes` to a file beside `path` and renames it to `path`, so that nobody sees half of it,
/// also when several processes write the same file.
///
/// Throws Error (where = the path) if it cannot be written; nothing is left behind then, and an
/// older file of that name stays as it was.
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace ink::core
