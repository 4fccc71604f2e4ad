#include "shade/compose.h"

#include <gtest/gtest.h>

#include <limits>

namespace ink::shade {
namespace {

TEST(To8Bit, RoundsAndLimits) {
    EXPECT_EQ(to_8_bit({0.5F, -3, 7}), Rgb(128, 0, 255));
    const float nothing = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(to_8_bit({1.0F / 255, nothing, 254.4F / 255}), Rgb(1, 0, 254));
}

TEST(Compose, InkGoesWhereTheResponseReachesTheThreshold) {
    core::Image<std::uint8_t> edge_responses(3, 1);
    edge_responses.at(0, 0) = 99;
    edge_responses.at(1, 0) = 100;
    edge_responses.at(2, 0) = 255;
    const core::Image<Rgb> image(3, 1, Rgb(10, 20, 30));
    const auto result = compose(edge_responses, image, {.color = {1, 2, 3}, .threshold = 100});
    EXPECT_EQ(result.at(0, 0), Rgb(10, 20, 30));
    EXPECT_EQ(result.at(1, 0), Rgb(1, 2, 3));
    EXPECT_EQ(result.at(2, 0), Rgb(1, 2, 3));
}

TEST(Compose, NothingOverNothingIsNothing) {
    EXPECT_TRUE(compose({}, {}, {}).is_empty());
}

TEST(Average, IsTheRoundedMeanOfEverySquare) {
    core::Image<Rgb> image(4, 2);
    image.at(0, 0) = {255, 3, 8};
    image.at(1, 0) = {255, 4, 0};
    image.at(0, 1) = {0, 3, 0};
    image.at(1, 1) = {0, 3, 0};
    image.at(2, 0) = {100, 200, 40};
    image.at(3, 0) = {100, 200, 40};
    image.at(2, 1) = {100, 200, 40};
    image.at(3, 1) = {100, 200, 40};
    const auto result = average(image, 2);
    ASSERT_EQ(result.width_px(), 2);
    ASSERT_EQ(result.height_px(), 1);
    EXPECT_EQ(result.at(0, 0), Rgb(128, 3, 2));  // 127.5, 3.25 and 2
    EXPECT_EQ(result.at(1, 0), Rgb(100, 200, 40));
}

TEST(Average, OfResponses) {
    core::Image<std::uint8_t> edge_responses(3, 3);
    edge_responses.at(1, 1) = 255;
    EXPECT_EQ(average(edge_responses, 3).at(0, 0), 28);  // 255 / 9 = 28.3
    EXPECT_EQ(average(edge_responses, 1), edge_responses);
    EXPECT_TRUE(average(core::Image<std::uint8_t>{}, 4).is_empty());
}

}  // namespace
}  // namespace ink::shade
