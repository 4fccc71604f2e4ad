#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "catalogue/catalogue.h"
#include "scene/animation.h"

namespace ink::catalogue {
namespace {

TEST(CatalogueGear, TurnsFromWhereItStands) {
    const scene::Scene rest = make_catalogue_scene("gear");
    ASSERT_NE(rest.animation, nullptr);
    scene::Scene scene = rest;
    scene::pose_scene(scene, 0);
    EXPECT_EQ(scene::scene_hash(scene), scene::scene_hash(rest));
    scene::pose_scene(scene, 2);
    // Half of half a turn: the point of the wheel that was on the right is on the top, or the
    // bottom.
    const glm::dvec3 before = scene::to_world(rest.instances[0], {1, 0, 0});
    const glm::dvec3 after = scene::to_world(scene.instances[0], {1, 0, 0});
    EXPECT_LT(glm::length(before - glm::dvec3(-1.3 + 1, 0, 0)), 1e-5);
    EXPECT_NEAR(after.x, -1.3, 1e-5);
    EXPECT_NEAR(std::abs(after.y), 1, 1e-5);
    // Teeth that meet move alike: at the rim both gears have the same speed.
    const double wheel_rad = std::numbers::pi / 2;
    const glm::dvec3 pinion = scene::to_world(scene.instances[1], {1, 0, 0}) -
                              scene::to_world(scene.instances[1], {0, 0, 0});
    const glm::dvec3 pinion_rest = scene::to_world(rest.instances[1], {1, 0, 0}) -
                                   scene::to_world(rest.instances[1], {0, 0, 0});
    EXPECT_NEAR(glm::dot(pinion, pinion_rest), std::cos(1.6 * wheel_rad), 1e-4);
}

}  // namespace
}  // namespace ink::catalogue
