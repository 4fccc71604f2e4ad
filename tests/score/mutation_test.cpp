// Faults planted in a perfect drawing, and the number that has to see each.

#include <gtest/gtest.h>

#include "score/score.h"
#include "tests/score/curves.h"

namespace {

using namespace ink;

constexpr int kSize_px = 120;
constexpr int kBand_px = 6;
constexpr int kLeft = 40;   ///< column of the left line
constexpr int kRight = 80;  ///< and of the right one
constexpr int kRows = kSize_px - 2 * kBand_px;

/// Two upright lines from frame to frame, `width` columns wide (odd), moved by `dx`.
Image lines(int width, int dx = 0) {
    return drawn_where(kSize_px, kSize_px, [&](double x, double) {
        const auto is_on = [&](int column) {
            return std::abs(x - dx - column - 0.5) < width / 2.0;
        };
        return is_on(kLeft) || is_on(kRight);
    });
}

score::Score score_of(const Image& drawn, double tolerance_px) {
    const score::ScoreOptions options{
        .tolerance_px = tolerance_px, .threshold = 1, .band_px = kBand_px};
    return score::score(drawn, score::prepare_truth(lines(1), options, true), options);
}

TEST(Mutation, NoneScoresOne) {
    for (const double tolerance_px : {0.5, 1.0, 2.0}) {
        const score::Score score = score_of(lines(1), tolerance_px);
        EXPECT_EQ(score.n_truth, 2 * kRows);
        EXPECT_EQ(score.f(), 1);
    }
}

TEST(Mutation, AShiftOfOnePixelIsSeenAtHalfAPixel) {
    EXPECT_EQ(score_of(lines(1, 1), 0.5).f(), 0);
    EXPECT_EQ(score_of(lines(1, 1), 2).f(), 1);
}

TEST(Mutation, AGhostThreePixelsBesideIsSeen) {
    Image drawn = lines(1);
    for (int y = 30; y < 90; ++y)
        drawn.at(kLeft + 3, y) = 1;
    const score::Score score = score_of(drawn, 2);
    EXPECT_EQ(score.k, 2 * kRows);
    EXPECT_EQ(score.false_positives, 60);
    EXPECT_EQ(score.n_pred, 2 * kRows + 60);
}

TEST(Mutation, GapsOfAFifthAreSeen) {
    Image drawn = lines(1);
    for (int y = 0; y < kSize_px; y += 5)
        drawn.at(kLeft, y) = drawn.at(kRight, y) = 0;
    const int gaps = 2 * 21;  // rows 10, 15 .. 110 of each line
    const score::Score score = score_of(drawn, 2);
    EXPECT_EQ(score.k, 2 * kRows - gaps);
    EXPECT_EQ(score.unmatched_truth, gaps);
    EXPECT_EQ(score.precision(), 1.0);
}

TEST(Mutation, WidthIsSeenByWidthAndNotByF) {
    for (const int width : {3, 5}) {
        const score::Score score = score_of(lines(width), 2);
        EXPECT_EQ(score.f(), 1);
        EXPECT_NEAR(score.mean_width_px, width, 0.04 * width);
    }
}

}  // namespace
