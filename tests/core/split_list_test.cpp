#include "core/split_list.h"

#include <gtest/gtest.h>

namespace ink::core {
namespace {

TEST(SplitList, LeavesOutWhatIsEmpty) {
    EXPECT_EQ(split_list("a,,b,"), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(split_list(" a b ,\tc, ,"), (std::vector<std::string>{"a b", "c"}));
    EXPECT_TRUE(split_list("").empty());
    EXPECT_TRUE(split_list("  ").empty());
}

}  // namespace
}  // namespace ink::core
