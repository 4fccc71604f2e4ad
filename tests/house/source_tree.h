#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ink::house {

/// A text file of the repository: its path from the root, with forward slashes, and its content.
struct SourceFile {
    std::string path;
    std::string text;
};

/// What the checks look at. Made from the disk by `read_tree`, or by hand in their own tests.
struct SourceTree {
    std::vector<std::string> folders;  ///< paths from the root, hidden ones but `.ci` left out
    std::vector<SourceFile> files;     ///< text files only

    /// The file called `path`, or nullptr.
    [[nodiscard]] const SourceFile* find(const std::string& path) const;
    [[nodiscard]] bool has_folder(const std::string& path) const;
};

/// Everything under `root` but what is made there: build trees, results, logs, git's own folder.
///
/// Walks the disk instead of asking git, so that it works in an unpacked archive. A file that holds
/// a zero byte is no text and is left out.
[[nodiscard]] SourceTree read_tree(const std::filesystem::path& root);

[[nodiscard]] bool starts_with(const std::string& text, const std::string& prefix);
[[nodiscard]] bool ends_with(const std::string& text, const std::string& suffix);

/// Whether the file is C++, generated headers' templates included.
[[nodiscard]] bool is_code(const SourceFile& file);

/// Calls `visit` with each line and its number, from 1.
void for_each_line(const SourceFile& file,
                   const std::function<void(int, const std::string&)>& visit);

/// "path:line: ", the head of a finding.
[[nodiscard]] std::string at(const SourceFile& file, int line);

}  // namespace ink::house
