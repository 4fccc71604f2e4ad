#include "shade/tones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "catalogue/shapes.h"
#include "tests/scene/small_meshes.h"

namespace ink::shade {
namespace {

using scene::scene_of;

constexpr double kCrease_rad = 2 * std::numbers::pi / 9;  // 40 degrees

std::size_t without_patch(const UniformSpots& spots) {
    return static_cast<std::size_t>(
        std::count(spots.of.begin(), spots.of.end(), UniformSpots::kNone));
}

TEST(PatchSpots, ABoxHasSixSidesEachWithItsMiddleAndNormal) {
    const auto spots =
        patch_spots(scene_of(catalogue::make_box({-1, -2, -3}, {1, 2, 3})), kCrease_rad);
    ASSERT_EQ(spots.spots.size(), 6U);
    EXPECT_EQ(without_patch(spots), 0U);
    for (const UniformSpots::Spot& spot : spots.spots) {
        // The middle of a side is its normal times the half extent.
        EXPECT_NEAR(glm::length(spot.n_world), 1, 1e-12);
        EXPECT_NEAR(glm::distance(spot.p_world, spot.n_world * glm::dvec3(1, 2, 3)), 0, 1e-9);
    }
}

TEST(PatchSpots, ACylindersCapsAreFlatAndItsSideIsNot) {
    const scene::Scene scene = scene_of(catalogue::make_cylinder(1, 2, 24));
    const auto spots = patch_spots(scene, kCrease_rad);
    EXPECT_EQ(spots.spots.size(), 2U);
    EXPECT_EQ(without_patch(spots), 48U);  // 24 quads, which bend by 15 degrees
}

TEST(PatchSpots, ASphereHasNoneAndAnEmptySceneToo) {
    EXPECT_TRUE(
        patch_spots(scene_of(catalogue::make_sphere(1, 32, 16)), kCrease_rad).spots.empty());
    EXPECT_TRUE(patch_spots({}, kCrease_rad).spots.empty());
}

TEST(FaceSpots, EveryTriangleHasItsCentroidAndNormal) {
    scene::Surface surface;
    surface.p_world = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
    surface.triangles = {{0, 1, 2}, {0, 2, 1}, {0, 0, 1}};
    const auto spots = face_spots(surface);
    ASSERT_EQ(spots.spots.size(), 3U);
    EXPECT_EQ(spots.spots[0].p_world, glm::dvec3(1, 1, 0));
    EXPECT_EQ(spots.spots[0].n_world, glm::dvec3(0, 0, 1));
    EXPECT_EQ(spots.spots[1].n_world, glm::dvec3(0, 0, -1));
    EXPECT_EQ(spots.spots[2].n_world, glm::dvec3(0, 0, 1));  // no area, no normal
}

}  // namespace
}  // namespace ink::shade
