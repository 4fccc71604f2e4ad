#include "shade/compose.h"

#include <gtest/gtest.h>

namespace ink::shade {
namespace {

TEST(LayInk, MixesLightNotNumbers) {
    core::Image<std::uint8_t> shares(4, 1);
    for (int x = 0; x < 4; ++x)
        shares.at(x, 0) = static_cast<std::uint8_t>(85 * x);
    const core::Image<glm::u8vec3> paper(4, 1, glm::u8vec3(255, 255, 100));
    const auto image = lay_ink(shares, paper, {0, 255, 20});
    EXPECT_EQ(image.at(0, 0), glm::u8vec3(255, 255, 100));
    // Two thirds and one third of white's light.
    EXPECT_EQ(image.at(1, 0), glm::u8vec3(213, 255, 83));
    EXPECT_EQ(image.at(2, 0), glm::u8vec3(156, 255, 61));
    EXPECT_EQ(image.at(3, 0), glm::u8vec3(0, 255, 20));
}

TEST(LayInk, AnyColourAtAFullShareIsThatColour) {
    for (int value = 0; value < 256; ++value) {
        const auto byte = static_cast<std::uint8_t>(value);
        const auto image = lay_ink(core::Image<std::uint8_t>(1, 1, 255),
                                   core::Image<glm::u8vec3>(1, 1, glm::u8vec3(77)),
                                   glm::u8vec3(byte));
        EXPECT_EQ(image.at(0, 0), glm::u8vec3(byte));
    }
}

}  // namespace
}  // namespace ink::shade
