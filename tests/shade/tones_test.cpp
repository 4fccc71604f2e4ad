#include "shade/tones.h"

#include <gtest/gtest.h>

#include <array>

namespace ink::shade {
namespace {

TEST(ToneAt, TheCosineIsTheKeyLampsWithItsSign) {
    const std::array lamps = {
        scene::OmniLight{.p_world = {3, 4, 0}, .color = {1, 1, 1}, .range = 10},
        scene::OmniLight{.p_world = {0, 9, 0}, .color = {1, 0, 0}, .range = 0}};
    const Tone lit = tone_at({0, 0, 0}, {0, 1, 0}, lamps, glm::vec3(0.1F));
    EXPECT_NEAR(lit.cosine, 0.8, 1e-6);
    EXPECT_NEAR(lit.light.r, 0.1 + 0.8 * 0.5 + 1, 1e-6);
    const Tone unlit = tone_at({0, 0, 0}, {0, -1, 0}, lamps, glm::vec3(0.1F));
    EXPECT_NEAR(unlit.cosine, -0.8, 1e-6);
    EXPECT_EQ(unlit.light, glm::vec3(0.1F));
}

TEST(ToneAt, WithoutLampsOrWithinTheKeyLampThereIsNoCosine) {
    const std::array lamp = {scene::OmniLight{.p_world = {1, 2, 3}, .color = {1, 1, 1}}};
    EXPECT_EQ(tone_at({1, 2, 3}, {0, 1, 0}, lamp, glm::vec3(0)).cosine, 0);
    EXPECT_EQ(tone_at({1, 2, 3}, {0, 1, 0}, {}, glm::vec3(0)).cosine, 0);
}

TEST(Brightness, IsLumaWithinZeroAndOne) {
    EXPECT_NEAR(brightness({1, 0, 0}), 0.299, 1e-6);
    EXPECT_NEAR(brightness({0, 1, 0}), 0.587, 1e-6);
    EXPECT_NEAR(brightness({0, 0, 1}), 0.114, 1e-6);
    EXPECT_EQ(brightness({3, 3, 3}), 1);
    EXPECT_EQ(brightness({-1, 0, 0}), 0);
}

TEST(MakeTones, BacksHaveTheNormalTurned) {
    scene::Surface surface;
    surface.p_world = {{0, 0, 0}};
    surface.n_world = {{0, 1, 0}};
    UniformSpots spots;
    spots.spots = {{{0, 0, 0}, {0, -1, 0}}};
    const std::array lamp = {scene::OmniLight{.p_world = {0, 5, 0}, .color = {1, 1, 1}}};
    const SurfaceTones tones = make_tones(surface, spots, lamp, glm::vec3(0));
    EXPECT_EQ(tones.vertices[0][0].cosine, 1);
    EXPECT_EQ(tones.vertices[1][0].cosine, -1);
    EXPECT_EQ(tones.spots[0][0].cosine, -1);
    EXPECT_EQ(tones.spots[1][0].cosine, 1);
}

}  // namespace
}  // namespace ink::shade
