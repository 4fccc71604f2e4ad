// Made-up sequences whose scores are known.

#include "score/motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "score/coverage.h"
#include "tests/score/curves.h"
#include "tests/score/images.h"

namespace {

using namespace ink;
using score::Flicker;

constexpr int kSize_px = 40;
constexpr double kTolerance_px = 2;
constexpr score::ScoreOptions kOptions{.tolerance_px = kTolerance_px, .threshold = 1};

/// Where an upright line stands from the top to the bottom; -1 for none.
using Columns = std::vector<int>;

Image lines_at(const Columns& columns) {
    Image image(kSize_px, kSize_px);
    for (const int x : columns) {
        for (int y = 0; y < kSize_px && x >= 0; ++y)
            image.at(x, y) = 1;
    }
    return image;
}

/// A sequence: what is drawn and what is true, frame by frame.
struct Sequence {
    std::vector<Image> drawn;
    std::vector<Image> truth;

    [[nodiscard]] std::vector<score::MotionFrame> frames(
        const score::ScoreOptions& options = kOptions) const {
        score::ScoreOptions unbanded = options;
        unbanded.band_px = 0;
        std::vector<score::MotionFrame> frames;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const auto scoring = score::prepare_truth(truth[i], unbanded, true);
            frames.push_back(score::motion_frame(drawn[i], scoring, options));
        }
        return frames;
    }
    [[nodiscard]] Flicker flicker() const { return score::flicker(frames(), kTolerance_px); }
    [[nodiscard]] std::vector<score::FalseLine> false_lines() const {
        return score::false_lines(frames(), kTolerance_px);
    }
};

/// One drawn and one true line a frame.
Sequence upright(const Columns& drawn, const Columns& truth) {
    Sequence sequence;
    for (const int x : drawn)
        sequence.drawn.push_back(lines_at({x}));
    for (const int x : truth)
        sequence.truth.push_back(lines_at({x}));
    return sequence;
}

TEST(Flicker, OfTheTruthItselfIsNoneHoweverItMoves) {
    EXPECT_EQ(upright({5, 5, 9, -1, 20}, {5, 5, 9, -1, 20}).flicker().share(), 0.0);
}

TEST(Flicker, OfAStillImageIsNoneEvenIfItIsWrong) {
    EXPECT_EQ(upright({30, 30, 30}, {5, 6, 7}).flicker().share(), 0.0);
}

TEST(Flicker, OfStepsWithinTheToleranceIsNoneAndBeyondItIsAll) {
    EXPECT_EQ(upright({10, 12, 10, 11}, {10, 10, 10, 10}).flicker().share(), 0.0);
    const Flicker jumps = upright({10, 13, 10}, {10, 10, 10}).flicker();
    EXPECT_EQ(jumps.share(), 1.0);
    EXPECT_EQ(jumps.appeared, 2 * kSize_px);
    EXPECT_EQ(jumps.disappeared, 2 * kSize_px);
    EXPECT_EQ(jumps.n_counted, 4 * kSize_px);
    EXPECT_EQ(jumps.excused, 0);
}

TEST(Flicker, OfALineDroppedForAFrameIsAllOfIt) {
    EXPECT_EQ(upright({10, -1, 10}, {10, 10, 10}).flicker(),
              (Flicker{.appeared = kSize_px, .disappeared = kSize_px, .n_counted = 2 * kSize_px}));
}

TEST(Flicker, ALineThatComesWithTheTruthIsExcused) {
    const Flicker comes = upright({-1, 11}, {-1, 10}).flicker();
    EXPECT_EQ(comes, (Flicker{.excused = kSize_px, .n_counted = kSize_px}));
    EXPECT_EQ(comes.share(), 0.0);
}

TEST(Flicker, ALineThatComesLateIsNot) {
    EXPECT_EQ(upright({-1, -1, 10}, {-1, 10, 10}).flicker().appeared, kSize_px);
}

TEST(Flicker, ALineThatTheTruthShowsElsewhereIsNot) {
    const Flicker elsewhere = upright({-1, 14}, {-1, 10}).flicker();
    EXPECT_EQ(elsewhere.appeared, kSize_px);
    EXPECT_EQ(elsewhere.excused, 0);
}

TEST(Flicker, OfNothingDrawnOrOfOneFrameIsNothing) {
    EXPECT_EQ(upright({-1, -1}, {10, 10}).flicker().share(), std::nullopt);
    EXPECT_EQ(upright({10}, {10}).flicker().share(), std::nullopt);
    EXPECT_EQ(score::flicker({}, kTolerance_px), Flicker{});
}

TEST(Flicker, OfImagesDrawnAtRandomIsHigh) {
    std::mt19937 random(7);
    Sequence sequence;
    for (int t = 0; t < 6; ++t) {
        sequence.drawn.push_back(random_image(kSize_px, kSize_px, 0.02, 1, random));
        sequence.truth.push_back(lines_at({10, 30}));
    }
    // 13 pixels are in reach, each empty with 0.98: 0.98^13 = 0.77.
    EXPECT_NEAR(*sequence.flicker().share(), 0.77, 0.08);
}

TEST(Flicker, APixelInTheBandIsSeenButNotCounted) {
    // The line goes from column 5, in the band, to 6 and back.
    const Sequence sequence = upright({5, 6, 5}, {5, 6, 5});
    score::ScoreOptions banded = kOptions;
    banded.band_px = 6;
    const Flicker flicker = score::flicker(sequence.frames(banded), kTolerance_px);
    EXPECT_EQ(flicker, (Flicker{.n_counted = 2 * (kSize_px - 12)}));
}

TEST(Flicker, IgnoredPixelsAreNotCounted) {
    Sequence sequence = upright({10, -1, 10}, {-1, -1, -1});
    for (Image& truth : sequence.truth)
        truth = Image(kSize_px, kSize_px, 7);
    score::ScoreOptions ignoring = kOptions;
    ignoring.ignore_label = 7;
    EXPECT_EQ(score::flicker(sequence.frames(ignoring), kTolerance_px), Flicker{});
    EXPECT_TRUE(score::false_lines(sequence.frames(ignoring), kTolerance_px).empty());
}

TEST(Flicker, ImagesOfTwoSizesAreAnError) {
    const auto truth = score::prepare_truth(lines_at({10}), kOptions, true);
    EXPECT_THROW((void)score::motion_frame(Image(8, 8), truth, kOptions), core::Error);
}

/// The ink of a level line, all of which counts.
score::InkTruth level_ink(double y_px) {
    return {score::draw_coverage(Curves{curve(-9, y_px, 99, y_px)}, 32, 32, 1.5),
            edge::Mask(32, 32, 1),
            1.5};
}

TEST(InkChange, OfTheTruthItselfIsItsOwnAndOfAStillImageLacksAllOfIt) {
    const score::InkTruth before = level_ink(16);
    const score::InkTruth after = level_ink(16.125);
    const auto own = ink_change(before.coverage, before, after.coverage, after);
    EXPECT_NEAR(own.true_px, 32 * (0.125 + 0.125), 0.01);  // on one side more, on the other less
    EXPECT_EQ(own.beyond_px, 0);
    const auto still = ink_change(before.coverage, before, before.coverage, after);
    EXPECT_EQ(still, (score::InkChange{own.true_px, own.true_px}));
}

TEST(InkChange, BeforeAStillTruthIsAllBeyond) {
    const score::InkTruth truth = level_ink(16);
    EXPECT_EQ(ink_change(truth.coverage, truth, truth.coverage, truth), score::InkChange{});
    const auto drawn = ink_change(truth.coverage, truth, level_ink(20).coverage, truth);
    EXPECT_NEAR(drawn.beyond_px, 2 * 32 * 1.5, 0.01);
}

TEST(InkChange, IsOfPixelsThatCountInBothFrames) {
    score::InkTruth before = level_ink(16);
    score::InkTruth after = level_ink(17);
    const double all_px = ink_change(before.coverage, before, after.coverage, after).true_px;
    for (int y = 0; y < 32; ++y)
        before.counts.at(3, y) = after.counts.at(4, y) = 0;
    const auto fewer = ink_change(before.coverage, before, after.coverage, after);
    EXPECT_NEAR(fewer.true_px, all_px * 30 / 32, 0.01);
}

TEST(FalseLines, OfTheTruthThereAreNone) {
    EXPECT_TRUE(upright({5, 9, 20}, {5, 9, 20}).false_lines().empty());
    EXPECT_TRUE(upright({7}, {5}).false_lines().empty());  // in reach
    EXPECT_TRUE(score::false_lines({}, kTolerance_px).empty());
}

TEST(FalseLines, LiveFromTheirFirstFrameToTheirLast) {
    const auto lines = upright({-1, 30, 31, 33, -1, 30}, {5, 5, 5, 5, 5, 5}).false_lines();
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0],
              (score::FalseLine{.first_frame = 1, .last_frame = 3, .n_px = 3 * kSize_px}));
    EXPECT_EQ(lines[0].life(), 3);
    EXPECT_EQ(
        lines[1],
        (score::FalseLine{.first_frame = 5, .last_frame = 5, .n_px = kSize_px, .is_cut = true}));
}

TEST(FalseLines, ThereInTheFirstFrameMayHaveBegunBefore) {
    const auto lines = upright({30, 30, -1, -1}, {5, 5, 5, 5}).false_lines();
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].is_cut);
}

TEST(FalseLines, AJumpBeyondTheToleranceIsAnotherLine) {
    EXPECT_EQ(upright({20, 22}, {5, 5}).false_lines().size(), 1U);
    EXPECT_EQ(upright({20, 23}, {5, 5}).false_lines().size(), 2U);
}

TEST(FalseLines, TouchingPixelsAreOneLineAndOthersAreTwo) {
    const Rows diagonal = {"#....", ".#...", "..#..", ".....", "....#"};
    Sequence sequence;
    sequence.drawn = {image_of(diagonal)};
    sequence.truth = {Image(5, 5)};
    const auto lines = sequence.false_lines();
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].n_px, 3);
    EXPECT_EQ(lines[1].n_px, 1);
    sequence.drawn = {image_of({"#.#..", ".....", ".....", ".....", "....."})};
    EXPECT_EQ(sequence.false_lines().size(), 2U) << "a pixel between them";
}

TEST(FalseLines, ThatMergeAreOneLine) {
    Sequence sequence;
    sequence.drawn = {lines_at({20, 24}), lines_at({22})};
    sequence.truth = {lines_at({5}), lines_at({5})};
    const auto lines = sequence.false_lines();
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].n_px, 3 * kSize_px);
}

TEST(FalseLines, LivesAreCounted) {
    const std::vector<score::FalseLine> lines = {{.first_frame = 0, .last_frame = 0},
                                                 {.first_frame = 2, .last_frame = 3},
                                                 {.first_frame = 4, .last_frame = 4},
                                                 {.first_frame = 1, .last_frame = 5}};
    EXPECT_EQ(score::life_counts(lines), (std::vector<std::int64_t>{2, 1, 0, 0, 1}));
    EXPECT_TRUE(score::life_counts({}).empty());
}

/// What time does to a sequence must not depend on its direction.
TEST(Motion, RunsBackwardsWithTheSameScores) {
    std::mt19937 random(11);
    for (int round = 0; round < 20; ++round) {
        Sequence forwards;
        for (int t = 0; t < 5; ++t) {
            forwards.drawn.push_back(random_image(kSize_px, kSize_px, 0.03, 1, random));
            forwards.truth.push_back(random_image(kSize_px, kSize_px, 0.02, 1, random));
        }
        Sequence backwards = forwards;
        std::reverse(backwards.drawn.begin(), backwards.drawn.end());
        std::reverse(backwards.truth.begin(), backwards.truth.end());

        const Flicker there = forwards.flicker();
        const Flicker back = backwards.flicker();
        EXPECT_EQ(there.appeared, back.disappeared);
        EXPECT_EQ(there.disappeared, back.appeared);
        EXPECT_EQ(there.excused, back.excused);
        EXPECT_EQ(there.n_counted, back.n_counted);
        EXPECT_GT(there.excused, 0);
        EXPECT_EQ(score::life_counts(forwards.false_lines()),
                  score::life_counts(backwards.false_lines()));
    }
}

}  // namespace
