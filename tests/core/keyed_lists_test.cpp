#include "core/keyed_lists.h"

#include <gmock/gmock.h>

namespace ink::core {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(KeyedLists, HoldEachKeysEntriesAsTheyCame) {
    const KeyedLists<int> lists(3, [](auto take) {
        take(2, 7);
        take(0, 5);
        take(2, 4);
    });
    EXPECT_THAT(lists.of(0), ElementsAre(5));
    EXPECT_THAT(lists.of(1), IsEmpty());
    EXPECT_THAT(lists.of(2), ElementsAre(7, 4));
    EXPECT_THAT(lists.of(0, 2), ElementsAre(5, 7, 4));
    EXPECT_EQ(lists.key_count(), 3U);
    EXPECT_TRUE(KeyedLists<int>().empty());
}

}  // namespace
}  // namespace ink::core
