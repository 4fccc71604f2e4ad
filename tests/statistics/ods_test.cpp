#include "statistics/ods.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ink::statistics {
namespace {

using Curve = std::array<score::CurveCount, 99>;

/// Scores `k` of 10 truth pixels with as many predicted, from threshold 1 to `last`/100.
Curve counts_until(int last, std::int64_t k) {
    Curve counts;
    for (int i = 0; i < 99; ++i)
        counts[static_cast<std::size_t>(i)] = {i < last ? k : 0, 10, 10};
    return counts;
}

TEST(BestThreshold, IsTheLowestOfThoseWithTheHighestF) {
    Curve counts = counts_until(99, 5);
    counts[19].k = 9;  // threshold 20/100: edge response * 100 >= 255 * 20, so 51 is on
    counts[40].k = 9;
    EXPECT_EQ(best_threshold(counts), 51);
}

TEST(BestThreshold, OfNeighboursWithTheSameFIsTheMiddleOne) {
    // All or nothing at every threshold, as of a method that draws 0 and 255: 50 % of 255 is 128.
    EXPECT_EQ(best_threshold(counts_until(99, 9)), 128);
    // Thresholds 1 % to 21 %: the middle is 11 %, 28.05, which 29 is the first edge response above.
    EXPECT_EQ(best_threshold(counts_until(21, 9)), 29);
}

TEST(PooledAp, IsTheAreaUnderThePooledEnvelope) {
    // Together: 8 of 8 found with 16 drawn, then 2 of 8 with 2 drawn. 1/4 * 1 + 3/4 * 1/2.
    CellCurve one{"a", {}};
    CellCurve two{"a", {}};
    for (std::size_t i = 0; i < 99; ++i) {
        one.counts[i] = i < 40 ? score::CurveCount{4, 4, 4} : score::CurveCount{2, 2, 4};
        two.counts[i] = i < 40 ? score::CurveCount{4, 12, 4} : score::CurveCount{0, 0, 4};
    }
    const auto areas = pooled_ap({one, {"b", counts_until(99, 10)}, two});
    EXPECT_DOUBLE_EQ(areas.at("a"), 0.625);
    EXPECT_DOUBLE_EQ(areas.at("b"), 1);
}

}  // namespace
}  // namespace ink::statistics
