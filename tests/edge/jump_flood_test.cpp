#include "edge/jump_flood.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ink::edge {
namespace {

using Seeds = core::Image<NearestSeed>;

Seeds random_seeds(int width_px, int height_px, int count, unsigned seed) {
    std::mt19937 random(seed);
    Seeds seeds(width_px, height_px);
    for (int i = 0; i < count; ++i) {
        const auto x = static_cast<std::int16_t>(random() % static_cast<unsigned>(width_px));
        const auto y = static_cast<std::int16_t>(random() % static_cast<unsigned>(height_px));
        seeds.at(x, y) = {x, y};
    }
    return seeds;
}

double distance_px(const NearestSeed& seed, int x, int y) {
    return std::hypot(seed.x - x, seed.y - y);
}

/// The distance to the nearest seed, by looking at all.
double plain_distance_px(const Seeds& seeds, int x, int y) {
    double least = 1e9;
    for (int v = 0; v < seeds.height_px(); ++v) {
        for (int u = 0; u < seeds.width_px(); ++u) {
            if (!seeds.at(u, v).is_none())
                least = std::min(least, distance_px(seeds.at(u, v), x, y));
        }
    }
    return least;
}

TEST(JumpFlood, FindsTheNearestSeedButForAFewPixelsAndThenOneThatIsNearlyAsNear) {
    constexpr int kReach_px = 64;
    int wrong = 0;
    int known = 0;
    for (unsigned seed = 0; seed < 4; ++seed) {
        const Seeds given = random_seeds(61, 47, 5 + 40 * static_cast<int>(seed), seed);
        Seeds found = given;
        Seeds scratch;
        jump_flood(found, scratch, kReach_px);
        for (int y = 0; y < found.height_px(); ++y) {
            for (int x = 0; x < found.width_px(); ++x) {
                const NearestSeed& nearest = found.at(x, y);
                ASSERT_FALSE(nearest.is_none()) << x << ',' << y;
                ASSERT_EQ(given.at(nearest.x, nearest.y), nearest) << "a seed";
                const double expected_px = plain_distance_px(given, x, y);
                const double found_px = distance_px(nearest, x, y);
                EXPECT_LE(found_px, expected_px + 1);
                wrong += found_px > expected_px + 1e-9 ? 1 : 0;
                ++known;
            }
        }
    }
    EXPECT_LE(wrong, known / 200);
}

TEST(JumpFlood, ReachesAsFarAsItIsAskedTo) {
    for (const int reach_px : {0, 1, 2, 3, 5, 8}) {
        Seeds seeds(41, 41);
        seeds.at(20, 20) = {20, 20};
        Seeds scratch;
        jump_flood(seeds, scratch, reach_px);
        for (int y = 20 - reach_px; y <= 20 + reach_px; ++y) {
            for (int x = 20 - reach_px; x <= 20 + reach_px; ++x)
                EXPECT_FALSE(seeds.at(x, y).is_none()) << reach_px << " px: " << x << ',' << y;
        }
    }
    EXPECT_EQ(jump_flood_passes(0), 0);
    EXPECT_EQ(jump_flood_passes(1), 1);
    EXPECT_EQ(jump_flood_passes(3), 2);
    EXPECT_EQ(jump_flood_passes(4), 3);
    EXPECT_EQ(jump_flood_passes(8), 4);
}

TEST(JumpFlood, WithoutSeedsOrPixelsDoesNothing) {
    Seeds none(9, 5);
    Seeds scratch;
    jump_flood(none, scratch, 4);
    EXPECT_EQ(none, Seeds(9, 5));
    Seeds empty;
    jump_flood(empty, scratch, 4);
    EXPECT_TRUE(empty.is_empty());
}

TEST(RoundSeeds, AreLinesOfTheirWidthBetweenTwoRowsOfSeeds) {
    const auto row_of = [](double width_px) {
        Seeds seeds(12, 5);
        for (std::int16_t y = 0; y < 5; ++y) {
            for (const std::int16_t x : {std::int16_t{5}, std::int16_t{6}})
                seeds.at(x, y) = {x, y};
        }
        Seeds scratch;
        jump_flood(seeds, scratch, 8);
        EdgeImage out(12, 5, 77);
        draw_round_seeds(seeds, width_px, out);
        return std::vector<int>(out.row(2), out.row(2) + 12);
    };
    EXPECT_EQ(row_of(1), (std::vector<int>{0, 0, 0, 0, 0, 128, 128, 0, 0, 0, 0, 0}));
    EXPECT_EQ(row_of(2), (std::vector<int>{0, 0, 0, 0, 0, 255, 255, 0, 0, 0, 0, 0}));
    EXPECT_EQ(row_of(3), (std::vector<int>{0, 0, 0, 0, 128, 255, 255, 128, 0, 0, 0, 0}));
    EXPECT_EQ(row_of(6), (std::vector<int>{0, 0, 0, 255, 255, 255, 255, 255, 255, 0, 0, 0}));
}

}  // namespace
}  // namespace ink::edge
