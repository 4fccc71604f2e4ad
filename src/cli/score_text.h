#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "draw/score_files.h"

namespace ink::cli {

/// One score as JSON, with the keys that scripts rely on.
[[nodiscard]] std::string score_json(const draw::FilesScore& scored);

/// One score as a table for a terminal.
[[nodiscard]] std::string score_table(const std::filesystem::path& prediction,
                                      const std::filesystem::path& truth,
                                      const draw::FilesScore& scored);

/// The scores of a folder: a line each, then all of them pooled.
[[nodiscard]] std::string folder_table(const std::vector<draw::FolderScore>& scores);

/// The same as JSON: {"images": {name: score or {"status"}}, "pooled": ...}.
[[nodiscard]] std::string folder_json(const std::vector<draw::FolderScore>& scores);

/// The same as CSV, a line per image.
[[nodiscard]] std::string folder_csv(const std::vector<draw::FolderScore>& scores);

}  // namespace ink::cli
