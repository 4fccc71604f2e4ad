#include "statistics/ods.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ink::statistics {
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
    curve.counts[19].k = 9;  // threshold 20/100: edge response * 100 >= 255 * 20, so 51 is on
    curve.counts[40].k = 9;
    const auto points = ods_on_training({curve});
    ASSERT_EQ(points.size(), 1U);
    EXPECT_EQ(points[0].threshold, 51);
    EXPECT_DOUBLE_EQ(points[0].f, 0.9);
}

TEST(Ods, OfNeighboursWithTheSameFIsTheMiddleOne) {
    // All or nothing at every threshold, as of a method that draws 0 and 255: 50 % of 255 is 128.
    EXPECT_EQ(ods_on_training({curve_until("a", 99, 9, true)})[0].threshold, 128);
    // Thresholds 1 % to 21 %: the middle is 11 %, 28.05, which 29 is the first edge response above.
    EXPECT_EQ(ods_on_training({curve_until("a", 21, 9, true)})[0].threshold, 29);
}

TEST(Ods, PoolsCountsAndNotScores) {
    CellCurve large = curve_until("a", 99, 0, true);
    CellCurve small = curve_until("a", 99, 0, true);
    large.counts.fill({900, 1000, 1000});
    small.counts.fill({0, 10, 10});
    EXPECT_DOUBLE_EQ(ods_on_training({large, small})[0].f, 2 * 900.0 / 2020);
}

/// A cell with F .8 at its lower thresholds and F .6 at its upper ones, or the other way round.
CellCurve two_level_curve(bool is_best_low) {
    CellCurve curve{"a", true, {}};
    for (std::size_t i = 0; i < 99; ++i) {
        const bool is_low = i < 50;
        curve.counts[i] = {is_low == is_best_low ? 80 : 60, 100, 100};
    }
    return curve;
}

TEST(Ois, LetsEveryImageHaveItsBestThreshold) {
    const auto one = summarise_curves({two_level_curve(true)});
    ASSERT_EQ(one.size(), 1U);
    EXPECT_DOUBLE_EQ(one[0].ods.f, 0.8);
    EXPECT_DOUBLE_EQ(one[0].ois, 0.8) << "of one image, ODS and OIS are the same";
    const auto two = summarise_curves({two_level_curve(true), two_level_curve(false)});
    EXPECT_DOUBLE_EQ(two[0].ods.f, 0.7) << "each threshold is good for one image only";
    EXPECT_DOUBLE_EQ(two[0].ois, 0.8);
}

TEST(Ois, IsAtLeastOdsWhereImagesDrawAlike) {
    // As many pixels drawn at every threshold: the best K of each then adds most to the pool.
    CellCurve rising{"a", true, {}};
    CellCurve falling{"a", false, {}};
    CellCurve humped{"a", true, {}};
    for (int i = 0; i < 99; ++i) {
        const auto at = static_cast<std::size_t>(i);
        rising.counts[at] = {i, 100, 100};
        falling.counts[at] = {98 - i, 100, 100};
        humped.counts[at] = {i < 30 ? i : 58 - std::min(i, 58), 100, 100};
    }
    const auto s = summarise_curves({rising, falling, humped})[0];
    EXPECT_DOUBLE_EQ(s.ods.f, (29 + 69 + 29) / 300.0);
    EXPECT_DOUBLE_EQ(s.ois, (98 + 98 + 29) / 300.0);
}

TEST(Ois, MayFallBelowOdsBecauseItPoolsWhatIsBestOfEach) {
    // Alone, the small drawing (F .667) beats the large one (F .65); in the pool it brings fewer
    // matches beside an image that is all wrong.
    CellCurve choosy{"a", true, {}};
    CellCurve hopeless{"a", true, {}};
    for (std::size_t i = 0; i < 99; ++i) {
        choosy.counts[i] =
            i < 50 ? score::CurveCount{65, 100, 100} : score::CurveCount{50, 50, 100};
        hopeless.counts[i] = {0, 500, 500};
    }
    const auto s = summarise_curves({choosy, hopeless})[0];
    EXPECT_DOUBLE_EQ(s.ods.f, 2 * 65 / 1200.0);
    EXPECT_DOUBLE_EQ(s.ois, 2 * 50 / 1150.0);
}

TEST(PooledAp, IsTheAreaUnderThePooledEnvelope) {
    // Together: 8 of 8 found with 16 drawn, then 2 of 8 with 2 drawn. 1/4 * 1 + 3/4 * 1/2.
    CellCurve one{"a", true, {}};
    CellCurve two{"a", true, {}};
    for (std::size_t i = 0; i < 99; ++i) {
        one.counts[i] = i < 40 ? score::CurveCount{4, 4, 4} : score::CurveCount{2, 2, 4};
        two.counts[i] = i < 40 ? score::CurveCount{4, 12, 4} : score::CurveCount{0, 0, 4};
    }
    EXPECT_DOUBLE_EQ(summarise_curves({one, two})[0].ap, 0.625);
}

TEST(Ods, HeldOutCellsDoNotVote) {
    const auto points = ods_on_training({curve_until("a", 99, 5, true),
                                         curve_until("a", 3, 10, false),
                                         curve_until("b", 3, 10, false)});
    ASSERT_EQ(points.size(), 1U);
    EXPECT_DOUBLE_EQ(points[0].f, 0.5);
}

}  // namespace
}  // namespace ink::statistics
