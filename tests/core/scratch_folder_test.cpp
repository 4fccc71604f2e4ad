#include "core/scratch_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace ink::core {
namespace {

namespace fs = std::filesystem;

TEST(ScratchFolder, IsNewAndGoneWithAllThatIsInIt) {
    fs::path path;
    {
        const ScratchFolder one("test");
        const ScratchFolder other("test");
        path = one.path();
        EXPECT_NE(path, other.path());
        EXPECT_TRUE(path.filename().string().starts_with("inkbench-test-")) << path;
        EXPECT_TRUE(fs::is_empty(path));
        fs::create_directories(path / "a/b");
        std::ofstream(path / "a/b/c.txt") << "c";
        EXPECT_TRUE(fs::exists(path / "a/b/c.txt"));
    }
    EXPECT_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace ink::core
