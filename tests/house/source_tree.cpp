#include "tests/house/source_tree.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

namespace ink::house {
namespace {

namespace fs = std::filesystem;

/// Top-level entries that are no part of the sources; the same as in .gitignore.
constexpr std::array kMade = {".git", "build", "inkbench-out", "bootstrap.log"};

std::string read_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

const SourceFile* SourceTree::find(const std::string& path) const {
    const auto found = std::find_if(
        files.begin(), files.end(), [&](const SourceFile& file) { return file.path == path; });
    return found == files.end() ? nullptr : &*found;
}

bool SourceTree::has_folder(const std::string& path) const {
    return std::find(folders.begin(), folders.end(), path) != folders.end();
}

bool starts_with(const std::string& text, const std::string& prefix) {
    return text.compare(0, prefix.size(), prefix) == 0;
}

bool ends_with(const std::string& text, const std::string& suffix) {
    return text.size() >= suffix.size() &&
           text.compare(text.size() - suffix.size(), suffix.size(), suffix) == 0;
}

bool is_code(const SourceFile& file) {
    return ends_with(file.path, ".h") || ends_with(file.path, ".cpp") ||
           ends_with(file.path, ".h.in");
}

void for_each_line(const SourceFile& file,
                   const std::function<void(int, const std::string&)>& visit) {
    std::istringstream lines(file.text);
    int number = 0;
    for (std::string line; std::getline(lines, line);)
        visit(++number, line);
}

std::string at(const SourceFile& file, int line) {
    return file.path + ":" + std::to_string(line) + ": ";
}

SourceTree read_tree(const std::filesystem::path& root) {
    SourceTree tree;
    for (auto entry = fs::recursive_directory_iterator(root);
         entry != fs::recursive_directory_iterator();
         ++entry) {
        const std::string path = entry->path().lexically_relative(root).generic_string();
        if (std::find(kMade.begin(), kMade.end(), path) != kMade.end()) {
            entry.disable_recursion_pending();
        } else if (entry->is_directory()) {
            tree.folders.push_back(path);
        } else if (entry->is_regular_file()) {
            std::string text = read_text(entry->path());
            if (text.find('\0') == std::string::npos) tree.files.push_back({path, text});
        }
    }
    std::sort(tree.folders.begin(), tree.folders.end());
    std::sort(tree.files.begin(), tree.files.end(), [](const auto& a, const auto& b) {
        return a.path < b.path;
    });
    return tree;
}

}  // namespace ink::house
