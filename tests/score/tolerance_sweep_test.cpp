#include <gtest/gtest.h>

#include <array>

#include "score/score.h"
#include "tests/score/images.h"

namespace {

using ink::score::prepare_truth;
using ink::score::Score;
using ink::score::ScoreOptions;

constexpr std::array<double, 5> kTolerances_px = {1, 1.5, 2, 3, 4};

/// The score at each of kTolerances_px.
std::vector<Score> scores_of(const Image& drawn, const Image& labels, ScoreOptions options) {
    std::vector<Score> scores;
    for (const double tolerance_px : kTolerances_px) {
        options.tolerance_px = tolerance_px;
        scores.push_back(ink::score::score(drawn, prepare_truth(labels, {}, false), options));
    }
    return scores;
}

TEST(Ladder, FindsALineThatIsOffAsSoonAsItIsInReach) {
    // Five true pixels in a row, five drawn three rows below.
    const Image labels = image_of({".....", "11111", ".....", ".....", ".....", "....."});
    const Image drawn = image_of({".....", ".....", ".....", ".....", "#####", "....."});
    const std::vector<Score> scores = scores_of(drawn, labels, {.thin = false});
    const std::array<std::int64_t, 5> k = {0, 0, 0, 5, 5};
    for (std::size_t i = 0; i < k.size(); ++i) {
        EXPECT_EQ(scores[i].k, k[i]);
        EXPECT_EQ(scores[i].n_pred, 5);
        EXPECT_EQ(scores[i].n_truth, 5);
    }
}

TEST(Ladder, NeverFallsAsTheToleranceGrows) {
    std::mt19937 random(6);
    for (int i = 0; i < 20; ++i) {
        const Image drawn = random_image(40, 30, 0.1, 255, random);
        const Image labels = random_image(40, 30, 0.08, 5, random);
        const std::vector<Score> scores = scores_of(drawn, labels, {.threshold = 100});
        for (std::size_t t = 1; t < scores.size(); ++t) {
            EXPECT_GE(scores[t].k, scores[t - 1].k);
            EXPECT_EQ(scores[t].n_pred, scores[0].n_pred);
        }
        EXPECT_GT(scores.back().k, scores.front().k);
    }
}

}  // namespace
