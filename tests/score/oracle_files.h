#pragma once

#include <filesystem>
#include <string>

/// A file of oracle/: the images, and what the independent scorer in Python counted in them.
inline std::filesystem::path oracle_file(const std::string& name) {
    return std::filesystem::path(INK_SOURCE_DIR) / "tests/score/oracle" / name;
}
