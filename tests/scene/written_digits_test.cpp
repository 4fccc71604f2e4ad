#include "scene/precision/written_digits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <random>

#include "scene/topology.h"

namespace ink::scene {
namespace {

Mesh mesh_of(const std::vector<glm::vec3>& positions) {
    Mesh mesh;
    mesh.positions = positions;
    for (std::uint32_t v = 0; v + 2 < positions.size(); v += 3)
        mesh.triangles.push_back({v, v + 1, v + 2});
    return mesh;
}

TEST(WrittenDigits, AreThoseOfTheCoordinateWithTheMost) {
    EXPECT_DOUBLE_EQ(written_rounding(mesh_of({{1, 2, -3}, {40, 0, 7}})), 0.5);
    EXPECT_DOUBLE_EQ(written_rounding(mesh_of({{1, 2, -3.5F}, {40, 0, 7}})), 0.05);
    EXPECT_DOUBLE_EQ(written_rounding(mesh_of({{1, 2, -3.5F}, {40.017F, 0, 7}})), 0.0005);
}

TEST(WrittenDigits, AreNoneWhereFloatsAreNoFiner) {
    EXPECT_EQ(written_rounding(mesh_of({})), 0);
    EXPECT_EQ(written_rounding(mesh_of({{0, 0, 0}})), 0);
    EXPECT_EQ(written_rounding(mesh_of({{1.0F / 3, 0.5F, 2}})), 0);
    EXPECT_EQ(written_rounding(mesh_of({{3e7F, 1, 0}})), 0);
    // Beside a coordinate of a million floats are .0625 apart.
    EXPECT_EQ(written_rounding(mesh_of({{1e6F, 0.5F, 0}})), 0);
    EXPECT_DOUBLE_EQ(written_rounding(mesh_of({{1e5F, 0.5F, 0}})), 0.05);
}

TEST(WrittenDigits, AreFoundForEveryNumberOfDecimals) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> whole(-999, 999);
    for (int decimals = 0; decimals <= 5; ++decimals) {
        const double scale = std::pow(10.0, decimals);
        std::vector<glm::vec3> positions{{static_cast<float>(1 / scale), 0, 0}};
        for (int i = 0; i < 100; ++i)
            positions.push_back(
                glm::vec3(glm::dvec3(whole(random), whole(random), whole(random)) * (1 / scale)));
        EXPECT_NEAR(written_rounding(mesh_of(positions)) * scale, 0.5, 1e-12) << decimals;
    }
}

TEST(WrittenDigits, AreFoundThoughAReaderRoundsThemToTheNextFloat) {
    const float beside = std::nextafter(2.7183F, 3.0F);
    EXPECT_DOUBLE_EQ(written_rounding(mesh_of({{1, 2.7183F, -3.1416F}})), 5e-5);
    EXPECT_DOUBLE_EQ(written_rounding(mesh_of({{1, beside, -3.1416F}})), 5e-5);
}

TEST(WrittenDigits, ReachTheWorldByTheFarthestCorner) {
    Instance instance{0, glm::dmat4(1), "part"};
    EXPECT_DOUBLE_EQ(most_moved_world(instance, 0.1), 0.1 * std::sqrt(3.0));
    instance.world_from_object = glm::scale(glm::dmat4(1), glm::dvec3(2, 3, 6));
    EXPECT_DOUBLE_EQ(most_moved_world(instance, 0.1), 0.7);
    // A shear: x + y and x - y are no longer equally long.
    instance.world_from_object = glm::dmat4(1);
    instance.world_from_object[1] = glm::dvec4(-1, 1, 0, 0);
    EXPECT_DOUBLE_EQ(most_moved_world(instance, 1), std::sqrt(6.0));
}

TEST(WrittenDigits, CountWhereTheyAreMoreThanFloatsAndLessThanImagesShow) {
    // Thousandths in a box of 100: 1/64 px of an image 1800 px wide.
    Scene scene;
    scene.meshes.push_back(mesh_of({{0, 0, 0}, {60.001F, 0, 0}, {0, 80, 0}}));
    scene.instances.push_back({0, glm::dmat4(1), "part"});
    const Topology topology = weld(scene);
    ASSERT_EQ(topology.written_rounding_world.size(), 3U);
    for (const double rounding : topology.written_rounding_world)
        EXPECT_DOUBLE_EQ(rounding, 0.0005 * std::sqrt(3.0));
    // Tenths are more than an image 256 px wide hides.
    scene.meshes[0] = mesh_of({{0, 0, 0}, {60.1F, 0, 0}, {0, 80, 0}});
    EXPECT_TRUE(weld(scene).written_rounding_world.empty());
    // A second part with more digits stays a float's.
    scene.meshes[0] = mesh_of({{0, 0, 0}, {60.001F, 0, 0}, {0, 80, 0}});
    scene.meshes.push_back(mesh_of({{0, 0, 1.0F / 3}, {60, 0, 1}, {0, 80, 1}}));
    scene.instances.push_back({1, glm::dmat4(1), "other"});
    const Topology both = weld(scene);
    ASSERT_EQ(both.written_rounding_world.size(), 6U);
    EXPECT_EQ(both.written_rounding_world[3], both.rounding_world[3]);
}

}  // namespace
}  // namespace ink::scene
