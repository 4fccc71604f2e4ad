#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/error.h"
#include "import/import.h"
#include "tests/core/temp_folder.h"

namespace ink::import {

/// A test that writes small model files into a folder of its own, removed afterwards.
class ModelFiles : public testing::Test {
  protected:
    [[nodiscard]] std::filesystem::path write(const std::string& name,
                                              const std::string& content) const {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }
    [[nodiscard]] std::filesystem::path in_folder(const std::string& name) const {
        return folder_ / name;
    }

  private:
    core::TempFolder folder_;
};

/// What import_scene complains of, without the path; empty, and a failure, if it does not. Checks
/// that the message is one printable line about the right file.
inline std::string complaint(const std::filesystem::path& path, const ImportLimits& limits = {}) {
    try {
        (void)import_scene(path, {}, limits);
    } catch (const core::Error& error) {
        EXPECT_EQ(error.where(), path.string());
        const std::string line = error.what();
        for (const char c : line)
            EXPECT_TRUE(c >= 0x20 && c < 0x7f) << line;
        return error.what_happened();
    }
    ADD_FAILURE() << path << " was imported";
    return {};
}

inline constexpr const char* kTriangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

}  // namespace ink::import
