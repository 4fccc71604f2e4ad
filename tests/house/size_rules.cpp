#include <algorithm>
#include <map>

#include "tests/house/house_rules.h"

namespace ink::house {
namespace {

constexpr int kMostFiles = 60;
constexpr int kMostLines = 4300;

struct FolderSize {
    int files = 0;
    int lines = 0;
};

bool is_in_room(const std::string& path) {
    return starts_with(path, "src/") || starts_with(path, "methods/");
}

bool is_source(const SourceFile& file) {
    return is_code(file) || ends_with(file.path, ".inl");
}

}  // namespace

Findings check_sizes(const SourceTree& tree) {
    std::map<std::string, FolderSize> sizes;
    for (const SourceFile& file : tree.files) {
        if (!is_in_room(file.path) || !is_source(file)) continue;
        FolderSize& size = sizes[file.path.substr(0, file.path.rfind('/'))];
        size.files += 1;
        size.lines += static_cast<int>(std::count(file.text.begin(), file.text.end(), '\n'));
    }
    Findings findings;
    for (const auto& [folder, size] : sizes) {
        if (size.files > kMostFiles) {
            findings.push_back(folder + ": " + std::to_string(size.files) + " files");
        }
        if (size.lines > kMostLines) {
            findings.push_back(folder + ": " + std::to_string(size.lines) + " lines");
        }
    }
    return findings;
}

}  // namespace ink::house
