#include "core/whole_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/error.h"
#include "tests/core/temp_folder.h"

namespace ink::core {
namespace {

namespace fs = std::filesystem;

class WholeFile : public testing::Test {
  protected:
    std::string text_of(const fs::path& path) {
        std::ostringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }
    std::ptrdiff_t entries() {
        return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
    }
    TempFolder folder_;
};

TEST_F(WholeFile, ReplacesAnOlderOneByteForByteAndLeavesNothingBeside) {
    const fs::path path = folder_ / "a.bin";
    write_whole_file(path, "old and longer");
    write_whole_file(path, std::string_view("n\0w\r\n", 5));
    EXPECT_EQ(text_of(path), std::string("n\0w\r\n", 5));
    EXPECT_EQ(entries(), 1);
}

TEST_F(WholeFile, WhereItCannotStandIsAnErrorAndNothingIsLeft) {
    EXPECT_THROW(write_whole_file(folder_ / "nowhere" / "a.bin", "x"), Error);
    fs::create_directories(folder_ / "taken" / "full");
    EXPECT_THROW(write_whole_file(folder_ / "taken", "x"), Error);  // a folder has that name
    EXPECT_EQ(entries(), 1);
}

TEST_F(WholeFile, IsReadAsItWasWritten) {
    const fs::path path = folder_ / "a.bin";
    const std::string bytes("\0\r\n\x1a", 4);
    write_whole_file(path, bytes);
    EXPECT_EQ(read_whole_file(path), bytes);
    write_whole_file(path, "");
    EXPECT_EQ(read_whole_file(path), "");
}

TEST_F(WholeFile, WhatIsNoFileIsNothing) {
    EXPECT_EQ(read_whole_file(folder_ / "nowhere"), std::nullopt);
    EXPECT_EQ(read_whole_file(folder_.path()), std::nullopt);
}

}  // namespace
}  // namespace ink::core
