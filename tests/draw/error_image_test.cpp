#include "draw/error_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "draw/palette.h"
#include "score/score.h"
#include "tests/report/made_up_rows.h"
#include "tests/score/images.h"

namespace ink::draw {
namespace {

/// A mark as a letter: '.' paper, '-' ignored, 'h' hit, 'f' false, 'm' missing.
char letter(Mark mark) {
    if (is_wrong(mark)) return score::is_miss(cause_of(mark)) ? 'm' : 'f';
    return ".-h"[static_cast<int>(mark)];
}

std::vector<std::string> letters(const Marks& marks) {
    std::vector<std::string> rows;
    for (int y = 0; y < marks.height_px(); ++y) {
        std::string& row = rows.emplace_back();
        for (int x = 0; x < marks.width_px(); ++x)
            row += letter(marks.at(x, y));
    }
    return rows;
}

using Letters = std::vector<std::string>;

TEST(MarkErrors, SaysOfEveryPixelWhatItIs) {
    const auto labels = image_of({".....", "11111", ".....", "....7", "33..."});
    const auto drawn = image_of({".....", "222..", ".....", "..2..", "....2"}, 100);
    EXPECT_EQ(
        letters(mark_errors(labels, drawn, {.threshold = 200, .tolerance_px = 1, .band_px = 0})),
        (Letters{".....", "hhh.m", ".....", "..f.-", "mm..-"}));
}

TEST(MarkErrors, WhatIsWeakerThanTheThresholdIsNotDrawn) {
    const auto labels = image_of({"...", "111", "..."});
    const auto drawn = image_of({"...", "111", "..."}, 100);
    const MarkOptions at_100{.threshold = 100, .tolerance_px = 1, .band_px = 0};
    const MarkOptions at_101{.threshold = 101, .tolerance_px = 1, .band_px = 0};
    EXPECT_EQ(letters(mark_errors(labels, drawn, at_100)), (Letters{"...", "hhh", "..."}));
    EXPECT_EQ(letters(mark_errors(labels, drawn, at_101)), (Letters{"...", "mmm", "..."}));
}

TEST(MarkErrors, AWideLineIsWhatItsMiddleIs) {
    core::Image<std::uint8_t> labels(20, 9);
    edge::EdgeImage drawn(20, 9);
    for (int x = 0; x < 20; ++x) {
        labels.at(x, 4) = 1;
        for (int y = 2; y <= 6; ++y)
            drawn.at(x, y) = 255;
    }
    const auto rows = letters(mark_errors(labels, drawn, {.tolerance_px = 2, .band_px = 0}));
    for (int y = 2; y <= 6; ++y) {
        EXPECT_EQ(rows[static_cast<std::size_t>(y)], std::string(20, 'h')) << y;
    }
}

TEST(MarkErrors, TheBandAtTheFrameIsNeitherWrongNorMissing) {
    const auto labels =
        image_of({"1......", "1......", "1......", "1......", "1......", "1......", "1......"});
    const auto drawn = image_of(
        {"......2", "......2", "......2", "......2", "......2", "......2", "......2"}, 100);
    for (const std::string& row :
         letters(mark_errors(labels, drawn, {.tolerance_px = 1, .band_px = 1}))) {
        EXPECT_EQ(row, "......-");
    }
}

TEST(MarkErrors, MissingAndFalsePixelsAreTheScoresOwn) {
    const auto labels = report::made_up_labels({}, 3);
    const auto drawn = report::made_up_drawing(labels, 0.3, 5);
    const Marks marks = mark_errors(labels, drawn, {});
    const score::ScoreOptions options{.band_px = 6, .ignore_label = 7};
    const auto score = score::score(drawn, score::prepare_truth(labels, options, true), options);
    const auto count = [&](char which) {
        return std::count_if(marks.data(), marks.data() + marks.size(), [which](Mark mark) {
            return letter(mark) == which;
        });
    };
    ASSERT_GT(score.false_negatives, 0);
    ASSERT_GT(score.false_positives, 0);
    EXPECT_EQ(count('m'), score.false_negatives);
    EXPECT_GE(count('f'), score.false_positives) << "with the width it was drawn with";
    EXPECT_EQ(count('f') > 0, score.false_positives > 0);
}

TEST(MarkErrors, WrongPixelsHaveTheCausesTheyAreGiven) {
    const auto labels = image_of({".....", "11...", ".....", ".....", "....."});
    const auto drawn = image_of({".....", ".....", ".....", ".....", "..222"}, 100);
    const std::vector<score::WrongPixel> wrong = {{{2, 4}, score::Cause::one_patch},
                                                  {{4, 4}, score::Cause::frame},
                                                  {{0, 1}, score::Cause::sub_pixel}};
    const Marks marks =
        mark_errors(labels, drawn, {.tolerance_px = 1, .band_px = 0, .wrong = wrong});
    EXPECT_EQ(marks.at(2, 4), mark_of(score::Cause::one_patch));
    EXPECT_EQ(marks.at(3, 4), mark_of(score::Cause::other)) << "nobody said why";
    EXPECT_EQ(marks.at(4, 4), mark_of(score::Cause::frame));
    EXPECT_EQ(marks.at(0, 1), mark_of(score::Cause::sub_pixel));
    EXPECT_EQ(marks.at(1, 1), mark_of(score::Cause::undeclared)) << "nobody said why";
}

TEST(MarkErrors, NothingGivesNothing) {
    EXPECT_TRUE(mark_errors({}, {}, {}).is_empty());
}

TEST(ErrorImage, HasAColourPerMark) {
    constexpr int kCount = 14;  // paper, ignored, hit, five causes of false lines and six of misses
    Marks marks(kCount, 1);
    for (int x = 0; x < kCount; ++x)
        marks.at(x, 0) = static_cast<Mark>(x);
    const RgbImage image = error_image(marks);
    for (int a = 0; a < kCount; ++a) {
        for (int b = 0; b < a; ++b)
            EXPECT_NE(image.at(a, 0), image.at(b, 0)) << a << " and " << b;
    }
    EXPECT_EQ(image.at(0, 0), glm::u8vec3(255, 255, 255));
    EXPECT_EQ(image.at(1, 0), kMist.rgb);
    EXPECT_EQ(image.at(2, 0), kInk.rgb);
    EXPECT_EQ(image.at(3, 0), kBlue.rgb);
    EXPECT_EQ(image.at(8, 0), kVermilion.rgb);
}

TEST(TruthImage, HasAColourPerClass) {
    const RgbImage image = truth_image(image_of({"0123457"}));
    for (int a = 0; a < 7; ++a) {
        for (int b = 0; b < a; ++b)
            EXPECT_NE(image.at(a, 0), image.at(b, 0)) << a << " and " << b;
    }
}

}  // namespace
}  // namespace ink::draw
