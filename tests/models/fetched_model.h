#pragma once

#include <filesystem>
#include <string>

/// Where `experiments/models/fetch` puts a real model of that file name. Tests must run without.
inline std::filesystem::path fetched_model(const std::string& file) {
    return std::filesystem::path(INK_SOURCE_DIR) / "inkbench-out/models" / file;
}

/// Skips the running test, and says what gets the model, where `path` (a fetched_model) is absent.
#define INK_SKIP_WITHOUT(path)                                                                     \
    if (!std::filesystem::exists(path)) {                                                          \
        GTEST_SKIP() << "skipped: experiments/models/fetch " << (path).stem().string() << " gets " \
                     << (path).filename().string() << ", which is not here";                       \
    }                                                                                              \
    static_assert(true)
