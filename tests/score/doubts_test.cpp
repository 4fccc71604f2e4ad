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
    EXPECT_EQ(doubt(faint), "no pixel counts as drawn: the strongest is 42, the threshold 128");
    edge::EdgeImage full(120, 90, 255);
    for (int y = 0; y < 90; ++y)
        full.at(5, y) = 0;
    EXPECT_EQ(doubt(full), "99 % of it count as drawn");
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
