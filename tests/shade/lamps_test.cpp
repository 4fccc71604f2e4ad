#include "shade/tones.h"

#include <gtest/gtest.h>

#include <array>

namespace ink::shade {
namespace {

scene::OmniLight lamp_at(const glm::dvec3& p_world, double range) {
    return {.p_world = p_world, .color = {1, 0.5F, 0}, .range = range};
}

TEST(Reach, FallsEvenlyAndEndsAtTheRange) {
    const scene::OmniLight lamp = lamp_at({0, 0, 0}, 8);
    EXPECT_EQ(reach(lamp, 0), 1);
    EXPECT_EQ(reach(lamp, 2), 0.75);
    EXPECT_EQ(reach(lamp, 8), 0);
    EXPECT_EQ(reach(lamp, 100), 0);
}

TEST(Reach, ARangeOfZeroReachesEverywhere) {
    EXPECT_EQ(reach(lamp_at({0, 0, 0}, 0), 1e9), 1);
}

TEST(LightAt, IsAmbientPlusCosineTimesReach) {
    // The lamp stands 5 away under a cosine of 0.8; half its range.
    const std::array lamps{lamp_at({3, 4, 0}, 10)};
    const glm::vec3 light = light_at({0, 0, 0}, {0, 1, 0}, lamps, glm::vec3(0.1F));
    EXPECT_NEAR(light.r, 0.1 + 0.8 * 0.5, 1e-6);
    EXPECT_NEAR(light.g, 0.1 + 0.8 * 0.5 * 0.5, 1e-6);
    EXPECT_NEAR(light.b, 0.1, 1e-6);
}

TEST(LightAt, LampsAddUp) {
    const std::array lamps{lamp_at({0, 1, 0}, 0), lamp_at({0, 2, 0}, 4)};
    EXPECT_NEAR(light_at({0, 0, 0}, {0, 1, 0}, lamps, glm::vec3(0)).r, 1.5, 1e-6);
}

TEST(LightAt, ALampBehindOrInTheSurfaceOrOutOfRangeLeavesAmbientAlone) {
    for (const glm::dvec3& p : {glm::dvec3(0, -1, 0), {0, 0, 0}, {0, 11, 0}}) {
        const std::array lamps{lamp_at(p, 10)};
        EXPECT_EQ(light_at({0, 0, 0}, {0, 1, 0}, lamps, glm::vec3(0.25F)), glm::vec3(0.25F));
    }
}

TEST(StudioLamps, OneReachesEverywhereAndOthersEnd) {
    scene::Camera camera;
    const auto lamps = studio_lamps(camera, {.center_world = {1, 2, 3}, .radius = 4});
    ASSERT_EQ(lamps.size(), 3U);
    EXPECT_EQ(lamps[0].range, 0);
    EXPECT_GT(lamps[1].range, 0);
    EXPECT_GT(lamps[2].range, 0);
}

}  // namespace
}  // namespace ink::shade
