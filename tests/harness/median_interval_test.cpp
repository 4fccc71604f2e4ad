#include "harness/median_interval.h"

#include <gtest/gtest.h>

namespace ink::harness {
namespace {

TEST(IsMedianKnown, NotOfFewerThanThree) {
    EXPECT_FALSE(is_median_known({}, 0.5));
    EXPECT_FALSE(is_median_known({100}, 0.5));
    EXPECT_FALSE(is_median_known({100, 100}, 0.5));
    EXPECT_TRUE(is_median_known({100, 100, 100}, 0.5));
}

TEST(IsMedianKnown, AllOfAFewMustLieCloseTogether) {
    // Of three the least and the greatest have the median between them in three cases of four.
    EXPECT_TRUE(is_median_known({102, 100, 101}, 0.02));
    EXPECT_FALSE(is_median_known({103, 100, 101}, 0.02));
}

TEST(IsMedianKnown, OfSixThatLieCloseOneMayStrayToEitherSide) {
    // Between the second and the fifth of six it lies in 1 - 14/64 of the cases; between the second
    // and the fourth of five in 1 - 12/32 only.
    EXPECT_TRUE(is_median_known({50, 100, 100, 100, 100, 900}, 0.02));
    EXPECT_FALSE(is_median_known({50, 100, 100, 100, 900}, 0.02));
    EXPECT_FALSE(is_median_known({50, 50, 100, 100, 100, 100}, 0.02));
}

TEST(IsMedianKnown, NeverToAShareOfNothing) {
    EXPECT_FALSE(is_median_known({100, 100, 100, 100}, 0));
}

}  // namespace
}  // namespace ink::harness
