#pragma once

#include <filesystem>
#include <string>

/// A file of the shared reference folder beside the project. Tests must run without that folder.
inline std::filesystem::path shared_file(const std::string& name) {
    return std::filesystem::path(INK_SHARED_DIR) / name;
}

/// Skips the running test, and says so, where `path` (a shared_file) is absent.
#define INK_SKIP_WITHOUT(path)                                                       \
    if (!std::filesystem::exists(path)) {                                            \
        GTEST_SKIP() << "skipped: " << (path).string() << " is not on this machine"; \
    }                                                                                \
    static_assert(true)
