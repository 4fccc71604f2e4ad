#include "scene/precision/written_digits.h"

#include <gmock/gmock.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <random>

#include "scene/topology.h"

namespace ink::scene {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::IsEmpty;

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

/// What digits may have moved a vertex by, of each object.
std::vector<double> roundings(const Scene& scene) {
    return weld(scene).written_rounding_world;
}

// Thousandths in a box of 100: 1/64 px of an image 1800 px wide.
const std::vector<glm::vec3> kThousandths{{0, 0, 0}, {60.001F, 0, 0}, {0, 80, 0}};

TEST(WrittenDigits, ReachTheWorldByTheFarthestCorner) {
    Scene scene;
    scene.meshes.push_back(mesh_of(kThousandths));
    scene.instances.push_back({0, glm::dmat4(1), "part"});
    glm::dmat4& world_from_object = scene.instances[0].world_from_object;
    EXPECT_THAT(roundings(scene), ElementsAre(DoubleEq(5e-4 * std::sqrt(3.0))));
    world_from_object = glm::scale(glm::dmat4(1), glm::dvec3(2, 3, 6));
    EXPECT_THAT(roundings(scene), ElementsAre(DoubleEq(5e-4 * 7)));
    // A shear: x + y and x - y are no longer equally long.
    world_from_object = glm::dmat4(1);
    world_from_object[1] = glm::dvec4(-1, 1, 0, 0);
    EXPECT_THAT(roundings(scene), ElementsAre(DoubleEq(5e-4 * std::sqrt(6.0))));
}

TEST(WrittenDigits, CountWhereAnImageHidesThem) {
    Scene scene;
    scene.meshes.push_back(mesh_of({{0, 0, 0}, {60.1F, 0, 0}, {0, 80, 0}}));
    scene.instances.push_back({0, glm::dmat4(1), "part"});
    EXPECT_THAT(roundings(scene), IsEmpty()) << "tenths are more than an image 256 px wide hides";
    scene.meshes.push_back(mesh_of(kThousandths));
    scene.instances.push_back({1, glm::dmat4(1), "other"});
    EXPECT_THAT(roundings(scene), ElementsAre(0, DoubleEq(5e-4 * std::sqrt(3.0))));
}

}  // namespace
}  // namespace ink::scene
