#include <gtest/gtest.h>

#include <array>

#include "score/score.h"
#include "tests/score/pictures.h"

namespace {

using ink::score::CurveCount;
using ink::score::prepare_truth;
using ink::score::score_ladder;
using ink::score::ScoreOptions;

constexpr std::array<double, 5> kTolerances_px = {1, 1.5, 2, 3, 4};

TEST(Ladder, EqualsAScoreAtEachTolerance) {
    std::mt19937 random(5);
    const Picture drawn = random_picture(60, 50, 0.2, 255, random);
    const Picture labels = random_picture(60, 50, 0.1, 7, random);
    const ScoreOptions options{.threshold = 90, .band_px = 3, .ignore_label = 7};
    const auto truth = prepare_truth(labels, options, false);
    const auto ladder = score_ladder(drawn, truth, options, kTolerances_px);
    ASSERT_EQ(ladder.size(), kTolerances_px.size());
    for (std::size_t i = 0; i < ladder.size(); ++i) {
        ScoreOptions at = options;
        at.tolerance_px = kTolerances_px[i];
        const auto s = ink::score::score(drawn, truth, at);
        EXPECT_EQ(ladder[i], (CurveCount{s.k, s.n_pred, s.n_truth})) << kTolerances_px[i];
    }
}

TEST(Ladder, FindsALineThatIsOffAsSoonAsItIsInReach) {
    // Five true pixels in a row, five drawn three rows below.
    const Picture labels = picture_of({".....", "11111", ".....", ".....", ".....", "....."});
    const Picture drawn = picture_of({".....", ".....", ".....", ".....", "#####", "....."});
    const auto ladder =
        score_ladder(drawn, prepare_truth(labels, {}, false), {.thin = false}, kTolerances_px);
    const std::array<std::int64_t, 5> k = {0, 0, 0, 5, 5};
    for (std::size_t i = 0; i < k.size(); ++i)
        EXPECT_EQ(ladder[i], (CurveCount{k[i], 5, 5}));
}

TEST(Ladder, NeverFallsAsTheToleranceGrows) {
    std::mt19937 random(6);
    for (int i = 0; i < 20; ++i) {
        const Picture drawn = random_picture(40, 30, 0.1, 255, random);
        const Picture labels = random_picture(40, 30, 0.08, 5, random);
        const auto ladder = score_ladder(
            drawn, prepare_truth(labels, {}, false), {.threshold = 100}, kTolerances_px);
        for (std::size_t t = 1; t < ladder.size(); ++t) {
            EXPECT_GE(ladder[t].k, ladder[t - 1].k);
            EXPECT_EQ(ladder[t].n_pred, ladder[0].n_pred);
        }
        EXPECT_GT(ladder.back().k, ladder.front().k);
    }
}

TEST(Ladder, WithoutTolerancesIsEmpty) {
    const Picture nothing(8, 8);
    EXPECT_TRUE(score_ladder(nothing, prepare_truth(nothing, {}, false), {}, {}).empty());
}

}  // namespace
