#include "shade/compose.h"

#include <gtest/gtest.h>

#include <limits>

namespace ink::shade {
namespace {

TEST(To8Bit, RoundsAndLimits) {
    core::Image<glm::vec3> picture(2, 1);
    picture.at(0, 0) = {0.5F, -3, 7};
    picture.at(1, 0) = {1.0F / 255, std::numeric_limits<float>::quiet_NaN(), 254.4F / 255};
    const auto result = to_8_bit(picture);
    EXPECT_EQ(result.at(0, 0), Rgb(128, 0, 255));
    EXPECT_EQ(result.at(1, 0), Rgb(1, 0, 254));
}

TEST(Compose, InkGoesWhereTheStrengthReachesTheThreshold) {
    core::Image<std::uint8_t> strengths(3, 1);
    strengths.at(0, 0) = 99;
    strengths.at(1, 0) = 100;
    strengths.at(2, 0) = 255;
    const core::Image<Rgb> picture(3, 1, Rgb(10, 20, 30));
    const auto result = compose(strengths, picture, {.color = {1, 2, 3}, .threshold = 100});
    EXPECT_EQ(result.at(0, 0), Rgb(10, 20, 30));
    EXPECT_EQ(result.at(1, 0), Rgb(1, 2, 3));
    EXPECT_EQ(result.at(2, 0), Rgb(1, 2, 3));
}

TEST(Compose, OverPlainPaper) {
    core::Image<std::uint8_t> strengths(2, 1);
    strengths.at(1, 0) = 200;
    const auto result = compose(strengths, Rgb(255, 250, 240), {});
    EXPECT_EQ(result.at(0, 0), Rgb(255, 250, 240));
    EXPECT_EQ(result.at(1, 0), Rgb(0, 0, 0));
}

TEST(Compose, NothingOverNothingIsNothing) {
    EXPECT_TRUE(compose({}, Rgb(255, 255, 255), {}).is_empty());
}

}  // namespace
}  // namespace ink::shade
