#include <gtest/gtest.h>

#include <array>

#include "score/score.h"
#include "tests/score/images.h"

namespace {

using ink::score::CurveCount;
using ink::score::prepare_truth;
using ink::score::score_tolerance_sweep;
using ink::score::ScoreOptions;

constexpr std::array<double, 5> kTolerances_px = {1, 1.5, 2, 3, 4};

TEST(Ladder, EqualsAScoreAtEachTolerance) {
    std::mt19937 random(5);
    const Image drawn = random_image(60, 50, 0.2, 255, random);
    const Image labels = random_image(60, 50, 0.1, 7, random);
    const ScoreOptions options{.threshold = 90, .band_px = 3, .ignore_label = 7};
    const auto truth = prepare_truth(labels, options, false);
    const auto tolerance_sweep = score_tolerance_sweep(drawn, truth, options, kTolerances_px);
    ASSERT_EQ(tolerance_sweep.size(), kTolerances_px.size());
    for (std::size_t i = 0; i < tolerance_sweep.size(); ++i) {
        ScoreOptions at = options;
        at.tolerance_px = kTolerances_px[i];
        const auto s = ink::score::score(drawn, truth, at);
        EXPECT_EQ(tolerance_sweep[i], (CurveCount{s.k, s.n_pred, s.n_truth})) << kTolerances_px[i];
    }
}

TEST(Ladder, FindsALineThatIsOffAsSoonAsItIsInReach) {
    // Five true pixels in a row, five drawn three rows below.
    const Image labels = image_of({".....", "11111", ".....", ".....", ".....", "....."});
    const Image drawn = image_of({".....", ".....", ".....", ".....", "#####", "....."});
    const auto tolerance_sweep = score_tolerance_sweep(
        drawn, prepare_truth(labels, {}, false), {.thin = false}, kTolerances_px);
    const std::array<std::int64_t, 5> k = {0, 0, 0, 5, 5};
    for (std::size_t i = 0; i < k.size(); ++i)
        EXPECT_EQ(tolerance_sweep[i], (CurveCount{k[i], 5, 5}));
}

TEST(Ladder, NeverFallsAsTheToleranceGrows) {
    std::mt19937 random(6);
    for (int i = 0; i < 20; ++i) {
        const Image drawn = random_image(40, 30, 0.1, 255, random);
        const Image labels = random_image(40, 30, 0.08, 5, random);
        const auto tolerance_sweep = score_tolerance_sweep(
            drawn, prepare_truth(labels, {}, false), {.threshold = 100}, kTolerances_px);
        for (std::size_t t = 1; t < tolerance_sweep.size(); ++t) {
            EXPECT_GE(tolerance_sweep[t].k, tolerance_sweep[t - 1].k);
            EXPECT_EQ(tolerance_sweep[t].n_pred, tolerance_sweep[0].n_pred);
        }
        EXPECT_GT(tolerance_sweep.back().k, tolerance_sweep.front().k);
    }
}

TEST(Ladder, WithoutTolerancesIsEmpty) {
    const Image nothing(8, 8);
    EXPECT_TRUE(score_tolerance_sweep(nothing, prepare_truth(nothing, {}, false), {}, {}).empty());
}

}  // namespace
