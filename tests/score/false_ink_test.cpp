#include "score/false_ink.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/score/pictures.h"

namespace {

using ink::score::InkCount;
using ink::score::ScoreOptions;

InkCount ink_of(const Picture& drawn, const Picture& labels, const ScoreOptions& options) {
    return count_ink(drawn, prepare_ink(prepare_truth(labels, options, false), options));
}

TEST(FalseInk, IsFurtherThanTheToleranceFromEveryTruthPixel) {
    const Picture truth = picture_of({"1.........", ".........."});
    const Picture drawn = picture_of({"1111111...", "1111111..."});
    EXPECT_EQ(ink_of(drawn, truth, {.tolerance_px = 2}).n_drawn, 14);
    // Near are x = 0, 1, 2 of the first row and 0, 1 of the second.
    EXPECT_EQ(ink_of(drawn, truth, {.tolerance_px = 2}).n_false, 9);
    EXPECT_EQ(ink_of(drawn, truth, {.tolerance_px = 2.5}).n_false, 8);
}

TEST(FalseInk, LeavesOutBandAndWhatLiesByIgnoreAlone) {
    const Picture truth = picture_of({"7......1..", "7.........", "7........."});
    const Picture drawn = picture_of({"..........", "1111111111", ".........."});
    // By ignore alone: 0, 1, 2. Near truth: 6, 7, 8. Left: 3, 4, 5, 9.
    const InkCount all = ink_of(drawn, truth, {.tolerance_px = 2, .ignore_label = 7});
    EXPECT_EQ(all.n_drawn, 7);
    EXPECT_EQ(all.n_false, 4);
    EXPECT_EQ(ink_of(drawn, truth, {.tolerance_px = 2, .band_px = 2, .ignore_label = 7}).n_drawn,
              0);
}

TEST(FalseInk, AgreesWithThePixelByPixelRule) {
    std::mt19937 random(31);
    for (int i = 0; i < 20; ++i) {
        const Picture labels = random_picture(50, 40, 0.01 + 0.002 * i, 7, random);
        const Picture drawn = random_picture(50, 40, 0.3, 1, random);
        const int band_px = i % 4;
        const ScoreOptions options{.tolerance_px = 2, .band_px = band_px, .ignore_label = 7};
        const auto in_band = [&](int x, int y) {
            return x < band_px || y < band_px || x >= 50 - band_px || y >= 40 - band_px;
        };
        const auto is_near = [&](int x, int y, bool is_ignore) {
            for (int v = std::max(0, y - 2); v <= std::min(39, y + 2); ++v) {
                for (int u = std::max(0, x - 2); u <= std::min(49, x + 2); ++u) {
                    if ((u - x) * (u - x) + (v - y) * (v - y) > 4 || in_band(u, v)) continue;
                    if (labels.at(u, v) != 0 && (labels.at(u, v) == 7) == is_ignore) return true;
                }
            }
            return false;
        };
        std::int64_t n_drawn = 0, n_false = 0;
        for (int y = 0; y < 40; ++y) {
            for (int x = 0; x < 50; ++x) {
                if (drawn.at(x, y) == 0 || in_band(x, y)) continue;
                const bool is_true = is_near(x, y, false);
                if (!is_true && is_near(x, y, true)) continue;
                ++n_drawn;
                n_false += !is_true;
            }
        }
        const InkCount count = ink_of(drawn, labels, options);
        ASSERT_EQ(count.n_drawn, n_drawn);
        ASSERT_EQ(count.n_false, n_false);
    }
}

TEST(FalseInk, OfNothingIsNone) {
    EXPECT_EQ(ink_of(Picture(5, 4), Picture(5, 4), {}).n_drawn, 0);
    EXPECT_EQ(ink_of(Picture(5, 4, 1), Picture(5, 4), {}).n_false, 20);
    EXPECT_EQ(ink_of(Picture(), Picture(), {}).n_drawn, 0);
    EXPECT_THROW(static_cast<void>(ink_of(Picture(5, 4), Picture(4, 5), {})), ink::core::Error);
}

}  // namespace
