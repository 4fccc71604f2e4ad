#include "statistics/spread.h"

#include <gtest/gtest.h>

namespace ink::statistics {
namespace {

TEST(Quantile, IsLinearBetweenNeighbours) {
    EXPECT_DOUBLE_EQ(*quantile({4, 1, 3, 2}, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(*quantile({10, 20}, 0.25), 12.5);
    EXPECT_DOUBLE_EQ(*quantile({7}, 1), 7);
    EXPECT_FALSE(quantile({}, 0.5));
}

TEST(Mean, OfNothingIsNothing) {
    EXPECT_DOUBLE_EQ(*mean({1, 2, 6}), 3);
    EXPECT_FALSE(mean({}));
}

}  // namespace
}  // namespace ink::statistics
