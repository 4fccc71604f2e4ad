#include "shade/hand_lines.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/hash.h"

namespace ink::shade {
namespace {

using Mask = core::Image<std::uint8_t>;

constexpr int kWidth_px = 120;
constexpr int kHeight_px = 40;
constexpr int kLine_px = 20;  ///< row of the line, from column 20 to 99

Mask straight_line() {
    Mask mask(kWidth_px, kHeight_px);
    std::fill_n(mask.row(kLine_px) + 20, 80, std::uint8_t{1});
    return mask;
}

/// No jitter, no overshoot, no change of width: a ruler's line.
HandParams ruler() {
    return {.jitter_px = 0, .overshoot_px = 0, .width_spread = 0, .taper_px = 0};
}

int inked_in_column(const Mask& image, int x) {
    int count = 0;
    for (int y = 0; y < image.height_px(); ++y)
        count += image.at(x, y) == 255 ? 1 : 0;
    return count;
}

int last_inked_column(const Mask& image) {
    int x = image.width_px() - 1;
    while (x >= 0 && inked_in_column(image, x) == 0)
        --x;
    return x;
}

TEST(DrawByHand, WithoutAHandItIsTheLineInItsWidth) {
    const Mask image = draw_by_hand(straight_line(), ruler(), {.line_width_px = 3});
    for (int x = 25; x < 95; ++x) {
        EXPECT_EQ(inked_in_column(image, x), 3);
        EXPECT_EQ(image.at(x, kLine_px), 255);
    }
    EXPECT_NEAR(last_inked_column(image), 100, 1);  // half its width beyond the last pixel
}

TEST(DrawByHand, SeedsReproduceAndAnotherSeedDiffers) {
    const HandParams params;
    const Mask one = draw_by_hand(straight_line(), params, {.seed = 7});
    EXPECT_EQ(draw_by_hand(straight_line(), params, {.seed = 7}), one);
    EXPECT_NE(draw_by_hand(straight_line(), params, {.seed = 8}), one);
}

TEST(DrawByHand, OvershootRunsBeyondTheEnds) {
    HandParams params = ruler();
    params.overshoot_px = 10;
    const Mask image = draw_by_hand(straight_line(), params, {.line_width_px = 1});
    // Between 0.4 and 1 of it, beyond the centre of the last pixel.
    EXPECT_GE(last_inked_column(image), 99 + 3);
    EXPECT_LE(last_inked_column(image), 99 + 11);
}

TEST(DrawByHand, JitterStaysWithinItsBounds) {
    HandParams params = ruler();
    params.jitter_px = 5;
    const Mask image = draw_by_hand(straight_line(), params, {.line_width_px = 1});
    int off = 0;
    for (int y = 0; y < kHeight_px; ++y) {
        const bool is_inked = std::count(image.row(y), image.row(y) + kWidth_px, 255) > 0;
        if (!is_inked) continue;
        EXPECT_LE(std::abs(y - kLine_px), 6);
        off = std::max(off, std::abs(y - kLine_px));
    }
    EXPECT_GE(off, 1);
}

TEST(DrawByHand, WidthSwellsAndShrinksAndTapers) {
    HandParams params = ruler();
    params.width_spread = 0.5;
    params.wave_px = 10;
    params.taper_px = 20;
    const Mask image = draw_by_hand(straight_line(), params, {.line_width_px = 8});
    int thinnest = kHeight_px;
    int thickest = 0;
    for (int x = 45; x < 75; ++x) {
        thinnest = std::min(thinnest, inked_in_column(image, x));
        thickest = std::max(thickest, inked_in_column(image, x));
    }
    EXPECT_LT(thinnest, thickest);
    EXPECT_LE(thickest, 13);  // 8 * 1.5, and rounding
    EXPECT_LT(inked_in_column(image, 21), 8);
}

TEST(DrawByHand, MorePassesMakeMoreInk) {
    HandParams params = ruler();
    params.jitter_px = 4;
    const auto ink = [&](int passes) {
        params.passes = passes;
        const Mask image = draw_by_hand(straight_line(), params, {.line_width_px = 1});
        return std::count(image.data(), image.data() + image.size(), 255);
    };
    EXPECT_GT(ink(3), ink(1));
}

TEST(DrawByHand, LengthsAreInPixelsOfTheUser) {
    // The same line, seen through 4 x 4 samples a pixel.
    Mask fine(4 * kWidth_px, 4 * kHeight_px);
    std::fill_n(fine.row(4 * kLine_px) + 80, 320, std::uint8_t{1});
    const Mask image = draw_by_hand(fine, ruler(), {.samples_per_px = 4, .line_width_px = 3});
    EXPECT_NEAR(inked_in_column(image, 240), 12, 1);
}

TEST(DrawByHand, SpecksAreLeftOut) {
    Mask mask(30, 30);
    mask.at(3, 3) = mask.at(4, 3) = 1;
    const Mask nothing(30, 30);
    EXPECT_EQ(draw_by_hand(mask, HandParams{}, {}), nothing);
    EXPECT_EQ(draw_by_hand(nothing, HandParams{}, {}), nothing);
    EXPECT_TRUE(draw_by_hand({}, HandParams{}, {}).is_empty());
}

TEST(DrawByHand, IsTheSameOnEveryMachine) {
    EXPECT_EQ(core::image_hash(draw_by_hand(straight_line(), HandParams{}, {.seed = 1})),
              "872632d44138521a");
}

}  // namespace
}  // namespace ink::shade
