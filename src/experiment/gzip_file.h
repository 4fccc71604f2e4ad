#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace ink::experiment {

/// What a gzip file holds (experiments/publish packs long tables so); nothing if there is none.
///
/// Throws core::Error (where = the path) for a file that is cut short or no gzip file.
[[nodiscard]] std::optional<std::string> read_gzip_file(const std::filesystem::path& path);

}  // namespace ink::experiment
