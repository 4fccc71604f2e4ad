#include "score/far_positives.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/score/images.h"

namespace {

using ink::score::PositiveCount;
using ink::score::ScoreOptions;

PositiveCount positives_of(const Image& drawn, const Image& labels, const ScoreOptions& options) {
    return count_positives(drawn,
                           prepare_positives(prepare_truth(labels, options, false), options));
}

TEST(FarPositives, IsFurtherThanTheToleranceFromEveryTruthPixel) {
    const Image truth = image_of({"1.........", ".........."});
    const Image drawn = image_of({"1111111...", "1111111..."});
    EXPECT_EQ(positives_of(drawn, truth, {.tolerance_px = 2}).n_drawn, 14);
    // Near are x = 0, 1, 2 of the first row and 0, 1 of the second.
    EXPECT_EQ(positives_of(drawn, truth, {.tolerance_px = 2}).n_false, 9);
    EXPECT_EQ(positives_of(drawn, truth, {.tolerance_px = 2.5}).n_false, 8);
}

TEST(FarPositives, LeavesOutBandAndWhatLiesByIgnoreAlone) {
    const Image truth = image_of({"7......1..", "7.........", "7........."});
    const Image drawn = image_of({"..........", "1111111111", ".........."});
    // By ignore alone: 0, 1, 2. Near truth: 6, 7, 8. Left: 3, 4, 5, 9.
    const PositiveCount all = positives_of(drawn, truth, {.tolerance_px = 2, .ignore_label = 7});
    EXPECT_EQ(all.n_drawn, 7);
    EXPECT_EQ(all.n_false, 4);
    EXPECT_EQ(
        positives_of(drawn, truth, {.tolerance_px = 2, .band_px = 2, .ignore_label = 7}).n_drawn,
        0);
}

TEST(FarPositives, AgreesWithThePixelByPixelRule) {
    std::mt19937 random(31);
    for (int i = 0; i < 20; ++i) {
        const Image labels = random_image(50, 40, 0.01 + 0.002 * i, 7, random);
        const Image drawn = random_image(50, 40, 0.3, 1, random);
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
        const PositiveCount count = positives_of(drawn, labels, options);
        ASSERT_EQ(count.n_drawn, n_drawn);
        ASSERT_EQ(count.n_false, n_false);
    }
}

TEST(FarPositives, OfNothingIsNone) {
    EXPECT_EQ(positives_of(Image(5, 4), Image(5, 4), {}).n_drawn, 0);
    EXPECT_EQ(positives_of(Image(5, 4, 1), Image(5, 4), {}).n_false, 20);
    EXPECT_EQ(positives_of(Image(), Image(), {}).n_drawn, 0);
    EXPECT_THROW(static_cast<void>(positives_of(Image(5, 4), Image(4, 5), {})), ink::core::Error);
}

}  // namespace
