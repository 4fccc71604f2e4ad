#include "score/drawn_matcher.h"

#include <gtest/gtest.h>

#include <random>

#include "score/matching.h"
#include "score/reach.h"

namespace ink::score {
namespace {

constexpr int kWidth_px = 150;
constexpr int kHeight_px = 40;

PixelList random_pixels(std::mt19937& random, int count) {
    core::Image<std::uint8_t> image(kWidth_px, kHeight_px);
    for (int i = 0; i < count; ++i)
        image.at(static_cast<int>(random() % kWidth_px), static_cast<int>(random() % kHeight_px)) =
            1;
    return PixelList(image);
}

TEST(DrawnMatcher, MatchesOneSetAfterTheOtherAsEachAlone) {
    std::mt19937 random(7);
    for (const double tolerance_px : {0.5, 1.0, 2.0, 4.0, 8.0}) {
        const Disk disk(tolerance_px);
        const PixelList drawn = random_pixels(random, 300);
        DrawnMatcher matcher(drawn, disk, kWidth_px);
        for (const int count : {200, 0, 1, 40, 900, 200}) {
            const PixelList truth = random_pixels(random, count);
            const std::int64_t k = match_pixels(drawn, truth, disk).k;
            EXPECT_EQ(matcher.match(truth), k) << tolerance_px << " px, " << count;
            EXPECT_EQ(count_pairs(drawn, truth, disk), k);
        }
    }
}

TEST(DrawnMatcher, NothingDrawnMatchesNothing) {
    std::mt19937 random(1);
    const PixelList drawn = random_pixels(random, 0);
    DrawnMatcher matcher(drawn, Disk(2), kWidth_px);
    EXPECT_EQ(matcher.match(random_pixels(random, 50)), 0);
}

TEST(ReachOf, HoldsThePixelsThatHaveOneInReach) {
    std::mt19937 random(3);
    core::Image<std::uint8_t> everywhere(kWidth_px, kHeight_px);
    everywhere.fill(1);
    const PixelList all(everywhere);
    for (const double tolerance_px : {1.0, 2.0, 3.0}) {
        for (const int count : {0, 5, 100, 2000}) {
            const PixelList pixels = random_pixels(random, count);
            const edge::BitMask reach = reach_of(pixels, Disk(tolerance_px), kWidth_px);
            const auto expected = within_reach(all, pixels, Disk(tolerance_px));
            for (std::size_t i = 0; i < all.size(); ++i) {
                const int y = static_cast<int>(i) / kWidth_px;
                ASSERT_EQ(reach.is_set(all.x(i), y), expected[i] != 0) << all.x(i) << "," << y;
            }
        }
    }
}

}  // namespace
}  // namespace ink::score
