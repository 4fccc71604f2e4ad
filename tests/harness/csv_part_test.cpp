#include <gtest/gtest.h>

#include <filesystem>

#include "harness/csv.h"

namespace ink::harness {
namespace {

TEST(CsvPart, StaysIfARunEndsBeforeItsTimeUnlessItHoldsNothing) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "ink_csv_part_test";
    std::filesystem::create_directories(folder);
    { CsvFile file(folder / "empty.csv", {"a"}); }
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    {
        CsvFile file(folder / "t.csv", {"a"});
        file.write("1");
    }
    EXPECT_TRUE(std::filesystem::exists(folder / "t.csv.part"));
    EXPECT_FALSE(std::filesystem::exists(folder / "t.csv"));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace ink::harness
