#include "lab/ods.h"

#include <gtest/gtest.h>

namespace ink::lab {
namespace {

/// A curve that scores `k` of 10 truth pixels with as many predicted, from threshold 1 to
/// `last`/100.
CellCurve curve_until(const std::string& method, int last, std::int64_t k, bool is_training) {
    CellCurve curve{method, is_training, {}};
    for (int i = 0; i < 99; ++i)
        curve.counts[static_cast<std::size_t>(i)] = {i < last ? k : 0, 10, 10};
    return curve;
}

TEST(Ods, TakesTheLowestOfTheBestThresholdsOfThePool) {
    CellCurve curve{"a", true, {}};
    for (auto& c : curve.counts)
        c = {5, 10, 10};
    curve.counts[19].k = 9;  // threshold 20/100: strength * 100 >= 255 * 20, so 51 is on
    curve.counts[40].k = 9;
    const auto points = ods_on_training({curve});
    ASSERT_EQ(points.size(), 1U);
    EXPECT_EQ(points[0].threshold, 51);
    EXPECT_DOUBLE_EQ(points[0].f, 0.9);
}

TEST(Ods, PoolsCountsAndNotScores) {
    CellCurve large = curve_until("a", 99, 0, true);
    CellCurve small = curve_until("a", 99, 0, true);
    large.counts.fill({900, 1000, 1000});
    small.counts.fill({0, 10, 10});
    EXPECT_DOUBLE_EQ(ods_on_training({large, small})[0].f, 2 * 900.0 / 2020);
}

TEST(Ods, HeldOutCellsDoNotVote) {
    const auto points = ods_on_training({curve_until("a", 99, 5, true),
                                         curve_until("a", 3, 10, false),
                                         curve_until("b", 3, 10, false)});
    ASSERT_EQ(points.size(), 1U);
    EXPECT_DOUBLE_EQ(points[0].f, 0.5);
}

}  // namespace
}  // namespace ink::lab
