#include "score/doubts.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace ink::score {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// An L and a slanted line, which no flip and no shift puts onto each other.
core::Image<std::uint8_t> drawing(int right_px = 0, int down_px = 0) {
    core::Image<std::uint8_t> image(120, 90, 0);
    const auto draw = [&](int x, int y) {
        if (image.contains(x + right_px, y + down_px)) image.at(x + right_px, y + down_px) = 255;
    };
    for (int i = 0; i < 40; ++i) {
        draw(20, 20 + i);
        draw(20 + i, 59);
        draw(40 + i, 20 + i / 3);
    }
    return image;
}

core::Image<std::uint8_t> flipped(bool in_x, bool in_y) {
    const auto from = drawing();
    core::Image<std::uint8_t> image(from.width_px(), from.height_px());
    for (int y = 0; y < image.height_px(); ++y) {
        for (int x = 0; x < image.width_px(); ++x) {
            image.at(x, y) =
                from.at(in_x ? image.width_px() - 1 - x : x, in_y ? image.height_px() - 1 - y : y);
        }
    }
    return image;
}

std::string doubt(const edge::EdgeImage& image) {
    const ScoreOptions options;
    const ScoringTruth truth = prepare_truth(drawing(), options, false);
    return doubt_of(image, truth, options, score(image, truth, options).f());
}

TEST(Doubts, NamesAFlip) {
    EXPECT_EQ(doubt(drawing()), "");
    EXPECT_EQ(doubt(flipped(false, true)), "it seems to be upside down");
    EXPECT_EQ(doubt(flipped(true, false)), "it seems to be mirrored");
    EXPECT_EQ(doubt(flipped(true, true)), "it seems to be turned by 180 degrees");
}

TEST(Doubts, NamesAShiftByAtMost16Px) {
    EXPECT_EQ(doubt(drawing(1, 1)), "") << "within the tolerance";
    EXPECT_EQ(doubt(drawing(4, 0)), "it seems to be shifted by 4 px to the right");
    EXPECT_EQ(doubt(drawing(0, -8)), "it seems to be shifted by 8 px up");
    EXPECT_EQ(doubt(drawing(-16, 16)),
              "it seems to be shifted by 16 px to the left and 16 px down");
    EXPECT_THAT(doubt(drawing(22, 22)), testing::Not(HasSubstr("shifted")));
}

TEST(Doubts, NamesABlankAndAFullImage) {
    EXPECT_EQ(doubt(edge::EdgeImage(120, 90, 255)), "it is blank");
    auto faint = drawing();
    std::transform(faint.data(), faint.data() + faint.size(), faint.data(), [](int v) {
        return static_cast<std::uint8_t>(v / 6);
    });
    EXPECT_EQ(doubt(faint),
              "no pixel counts as drawn: the strongest is 42, the threshold 128; at threshold 32 F "
              "would be 0.996");
    edge::EdgeImage full(120, 90, 255);
    for (int y = 0; y < 90; ++y)
        full.at(5, y) = 0;
    EXPECT_EQ(doubt(full), "99 % of it count as drawn");
}

TEST(Doubts, NamesABetterThreshold) {
    auto faint = drawing();
    for (int y = 0; y < 90; ++y)
        faint.at(20, y) = static_cast<std::uint8_t>(faint.at(20, y) / 3);
    for (int x = 0; x < 120; ++x)
        faint.at(x, 59) = static_cast<std::uint8_t>(faint.at(x, 59) / 3);
    EXPECT_EQ(doubt(faint),
              "its lines are faint, half of them at most 85 of 255: at threshold 64 F would be "
              "0.996");
    auto shaded = drawing();
    for (int x = 0; x < 120; ++x)
        shaded.at(x, 80) = 140;
    EXPECT_EQ(doubt(shaded), "much of its grey is no line: at threshold 160 F would be 0.996");
}

TEST(Doubts, NamesABorderOfAnotherColour) {
    for (const int border_px : {1, 7, 19}) {
        auto framed = drawing();
        auto inverse = drawing();
        for (int y = 0; y < 90; ++y) {
            for (int x = 0; x < 120; ++x) {
                const bool is_border = std::min({x, y, 119 - x, 89 - y}) < border_px;
                if (is_border) framed.at(x, y) = 255;
                inverse.at(x, y) =
                    static_cast<std::uint8_t>(is_border ? 0 : 255 - drawing().at(x, y));
            }
        }
        const std::string border = "a border of " + std::to_string(border_px) + " px around it";
        EXPECT_EQ(doubt(framed), border + " counts as drawn");
        EXPECT_EQ(doubt(inverse), "all but " + border + " counts as drawn");
    }
}

TEST(Doubts, NamesABorderOfTheGroundsColour) {
    constexpr int kBorder_px = 12;
    const auto large = drawing();
    for (const bool keeps_shape : {false, true}) {
        const double by_y = 90.0 / (90 - 2 * kBorder_px);
        const double by_x = keeps_shape ? by_y : 120.0 / (120 - 2 * kBorder_px);
        edge::EdgeImage small(120, 90, 0);
        for (int y = 0; y < 90; ++y) {
            for (int x = 0; x < 120; ++x) {
                const int at_x = static_cast<int>(60 + (x + 0.5 - 60) / by_x);
                const int at_y = static_cast<int>(45 + (y + 0.5 - 45) / by_y);
                if (large.at(x, y) != 0) small.at(at_x, at_y) = 255;
            }
        }
        EXPECT_THAT(doubt(small),
                    testing::ContainsRegex("it seems to have a border of about 1[123] px"));
    }
}

TEST(Doubts, NamesLinesThatAreNowhereNear) {
    edge::EdgeImage image(120, 90, 0);
    for (int x = 80; x < 119; ++x)
        image.at(x, 85) = 255;
    EXPECT_THAT(doubt(image), StartsWith("its lines are nowhere near the true ones"));
}

TEST(Doubts, SayNothingOfAnEmptyTruth) {
    const ScoreOptions options;
    const ScoringTruth truth = prepare_truth(core::Image<std::uint8_t>(120, 90, 0), options, false);
    EXPECT_EQ(doubt_of(drawing(), truth, options, 0), "");
}

}  // namespace
}  // namespace ink::score
