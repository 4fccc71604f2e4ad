#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "given_images/score_folders.h"

namespace ink::cli {

/// One score as JSON, with the names of folder_csv's columns. The names of before stand beside
/// them: surplus, off_line, lost, missing, mean_width.
[[nodiscard]] std::string score_json(const given_images::FilesScore& scored);

/// One score as a table for a terminal.
[[nodiscard]] std::string score_table(const std::filesystem::path& prediction,
                                      const std::string& truth_name,
                                      const given_images::FilesScore& scored);

/// The scores of a folder: a line each, then all of them pooled, and what has no score. For a
/// terminal, or as Markdown.
[[nodiscard]] std::string folder_table(const std::vector<given_images::FolderScore>& scores,
                                       bool is_markdown = false);

/// The same as JSON: {"images": {name: score or {"status"}}, "pooled": ..., "unmatched": [files]}.
[[nodiscard]] std::string folder_json(const std::vector<given_images::FolderScore>& scores,
                                      const std::vector<std::string>& unmatched);

/// The same as CSV, a line per image; the ink of grey lines by the names of rows.csv.
[[nodiscard]] std::string folder_csv(const std::vector<given_images::FolderScore>& scores);

}  // namespace ink::cli
