#include "shade/shading.h"

#include <gtest/gtest.h>

#include <set>

namespace ink::shade {
namespace {

void expect_color(const glm::vec3& color, const glm::vec3& expected) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(color[c], expected[c], 1e-6) << "channel " << c;
}

GoochParams gooch_params(LitSide lit) {
    GoochParams params;
    params.lit = lit;
    params.blue = 0.4;
    params.yellow = 0.4;
    params.cool_share = 0.2;
    params.warm_share = 0.6;
    return params;
}

const glm::vec3 kGooched{1, 0.5F, 0};        // the surface
const glm::vec3 kCool{0.2F, 0.1F, 0.4F};     // (0, 0, 0.4) + 0.2 surface
const glm::vec3 kWarm{1, 0.7F, 0};           // (0.4, 0.4, 0) + 0.6 surface
const glm::vec3 kBetween{0.6F, 0.4F, 0.2F};  // half of each

TEST(Gooch, AsPrintedTheLitSideIsCool) {
    const GoochParams params = gooch_params(LitSide::cool);
    expect_color(gooch(1, params, kGooched), kCool);
    expect_color(gooch(0, params, kGooched), kBetween);
    expect_color(gooch(-1, params, kGooched), kWarm);
}

TEST(Gooch, AsInThePapersImagesTheLitSideIsWarm) {
    const GoochParams params = gooch_params(LitSide::warm);
    expect_color(gooch(1, params, kGooched), kWarm);
    expect_color(gooch(0, params, kGooched), kBetween);
    expect_color(gooch(-1, params, kGooched), kCool);
}

TEST(ToonTable, HasThirtyTwoEntriesInAsManyLevelsAsAskedFor) {
    EXPECT_EQ(make_toon_table(3, 0).size(), 32U);
    for (const int steps : {1, 2, 3, 5, 32}) {
        const ToonTable table = make_toon_table(steps, 0.25);
        const std::set<float> levels(table.begin(), table.end());
        EXPECT_EQ(levels.size(), static_cast<std::size_t>(steps));
        EXPECT_TRUE(std::is_sorted(table.begin(), table.end()));
        EXPECT_EQ(table.back(), 1);
        EXPECT_EQ(table.front(), steps == 1 ? 1 : 0.25F);
    }
}

TEST(ToonTable, ThreeLevelsLieAtEqualDistancesOverThirds) {
    const ToonTable table = make_toon_table(3, 0.5);
    EXPECT_EQ(table[10], 0.5F);  // 10 * 3 / 32 = 0.94
    EXPECT_EQ(table[11], 0.75F);
    EXPECT_EQ(table[21], 0.75F);  // 21 * 3 / 32 = 1.97
    EXPECT_EQ(table[22], 1);
}

TEST(Splashback, AtZeroSixtyAndNinetyDegrees) {
    // alpha 0.8, p 3: (0.8 |cos t| + 0.2)^3.
    EXPECT_NEAR(splashback(1, 0.8, 3), 1, 1e-6);
    EXPECT_NEAR(splashback(0.5F, 0.8, 3), 0.216, 1e-6);
    EXPECT_NEAR(splashback(0, 0.8, 3), 0.008, 1e-6);
}

TEST(Splashback, IsTheSameBehindAndNothingForAlphaOrPowerZero) {
    EXPECT_EQ(splashback(-0.5F, 0.7, 2), splashback(0.5F, 0.7, 2));
    EXPECT_EQ(splashback(0.3F, 0, 9), 1);
    EXPECT_EQ(splashback(0.3F, 0.7, 0), 1);
}

/// The share of ink over many whole periods, point by point.
double positive_share(float darkness, const StrokeParams& params) {
    const StrokeShares shares = stroke_shares(darkness, params);
    int ink = 0;
    constexpr int kSide = 400;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x)
            ink += is_on_stroke(x + 0.5, y + 0.5, shares, params.spacing_px) ? 1 : 0;
    }
    return static_cast<double>(ink) / (kSide * kSide);
}

TEST(Strokes, InkGrowsWithDarkness) {
    const StrokeParams params;
    double last = 0;
    for (int i = 0; i <= 40; ++i) {
        const double share = positive_share(static_cast<float>(i) / 40, params);
        EXPECT_GE(share, last - 0.004) << "darkness " << i / 40.0;
        last = share;
    }
    EXPECT_EQ(positive_share(0, params), 0);
    EXPECT_NEAR(last, 0.75, 0.01);  // both at half their spacing
}

TEST(Strokes, AreCrossedBeyondTheSecondThresholdOnly) {
    StrokeParams params;
    params.single_from = 0.25;
    params.crossed_from = 0.5;
    const StrokeShares none = stroke_shares(0.24F, params);
    EXPECT_EQ(none.single, 0);
    EXPECT_EQ(none.crossed, 0);
    const StrokeShares single = stroke_shares(0.49F, params);
    EXPECT_GT(single.single, 0);
    EXPECT_EQ(single.crossed, 0);
    const StrokeShares crossed = stroke_shares(0.5F, params);
    EXPECT_EQ(crossed.single, 0.5F);
    EXPECT_GT(crossed.crossed, 0);
}

TEST(Strokes, RunUnderFortyFiveDegreesAndCrossAtRightAngles) {
    const StrokeShares single{0.5F, 0};
    const StrokeShares crossed{0, 0.5F};
    for (int i = 0; i < 30; ++i) {
        EXPECT_EQ(is_on_stroke(3 + i, 10 - i, single, 6), is_on_stroke(3, 10, single, 6));
        EXPECT_EQ(is_on_stroke(3 + i, 10 + i, crossed, 6), is_on_stroke(3, 10, crossed, 6));
    }
}

TEST(Strokes, ThresholdsThatMeetAreCrossedAtOnce) {
    StrokeParams params;
    params.single_from = params.crossed_from = 0.5;
    EXPECT_EQ(stroke_shares(0.6F, params).single, 0.5F);
    EXPECT_GT(stroke_shares(0.6F, params).crossed, 0);
}

}  // namespace
}  // namespace ink::shade
