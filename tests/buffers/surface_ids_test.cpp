#include "buffers/id_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <set>

#include "methods/registry.h"
#include "tests/methods/small_scenes.h"

namespace ink::buffers {
namespace {

const double kCrease_rad = glm::radians(40.0);

std::vector<std::uint32_t> ids_of(const scene::Scene& scene,
                                  IdSource source,
                                  double crease_rad = kCrease_rad) {
    return surface_ids(scene, source, {.crease_rad = crease_rad});
}

std::size_t distinct(const std::vector<std::uint32_t>& ids) {
    return std::set<std::uint32_t>(ids.begin(), ids.end()).size();
}

/// Squares in y = 0, beside each other, each an object of its own.
scene::Scene two_tiles() {
    scene::Scene scene = methods::scene_of({methods::floor_mesh(1), methods::floor_mesh(1)});
    scene.instances[1].world_from_object = glm::translate(glm::dmat4(1), {2, 0, 0});
    return scene;
}

TEST(SurfaceIds, ACubeIsOneObjectSixPatchesTwelveTriangles) {
    const scene::Scene cube = methods::scene_of({methods::cube_mesh()});
    EXPECT_EQ(distinct(ids_of(cube, IdSource::object)), 1U);
    EXPECT_EQ(distinct(ids_of(cube, IdSource::patch)), 6U);
    EXPECT_EQ(distinct(ids_of(cube, IdSource::object_and_patch)), 6U);
    EXPECT_EQ(distinct(ids_of(cube, IdSource::triangle)), 12U);
}

TEST(SurfaceIds, BendsBelowTheCreaseJoin) {
    const scene::Scene cube = methods::scene_of({methods::cube_mesh()});
    EXPECT_EQ(distinct(ids_of(cube, IdSource::patch, glm::radians(89.0))), 6U);
    EXPECT_EQ(distinct(ids_of(cube, IdSource::patch, glm::radians(91.0))), 1U);
}

TEST(SurfaceIds, CoplanarTilesOfTwoObjectsAreOnePatchUnlessObjectsCount) {
    EXPECT_EQ(distinct(ids_of(two_tiles(), IdSource::patch)), 1U);
    EXPECT_EQ(distinct(ids_of(two_tiles(), IdSource::object_and_patch)), 2U);
    EXPECT_EQ(distinct(ids_of(two_tiles(), IdSource::object)), 2U);
}

TEST(SurfaceIds, ATileTurnedTheOtherWayStillJoins) {
    scene::Scene scene = two_tiles();
    for (scene::Triangle& triangle : scene.meshes[1].triangles)
        std::swap(triangle[1], triangle[2]);
    EXPECT_EQ(distinct(ids_of(scene, IdSource::patch)), 1U);
}

TEST(SurfaceIds, ARepeatedTriangleHasTheIdOfTheFirst) {
    scene::Mesh mesh = methods::floor_mesh(1);
    const scene::Triangle first = mesh.triangles[0];
    mesh.triangles.push_back({first[1], first[2], first[0]});
    const auto ids = ids_of(methods::scene_of({mesh}), IdSource::object_and_patch);
    ASSERT_EQ(ids.size(), 3U);
    EXPECT_EQ(distinct(ids), 1U);
}

TEST(SurfaceIds, APatchKeepsItsIdWhenAnotherComesApart) {
    const scene::Scene together = two_tiles();
    scene::Scene apart = together;
    apart.instances[1].world_from_object = glm::translate(glm::dmat4(1), {5, 0, 0});
    const auto before = ids_of(together, IdSource::patch);
    const auto after = ids_of(apart, IdSource::patch);
    EXPECT_EQ(before[0], after[0]);
    EXPECT_NE(before[2], after[2]);
}

TEST(SurfaceIds, AnEpsilonClosesHairlineCracksWithinAnObject) {
    scene::Mesh mesh = methods::floor_mesh(1);
    for (const glm::vec3& p : methods::floor_mesh(1).positions)
        mesh.positions.push_back(p + glm::vec3(2.0001F, 0, 0));
    for (const scene::Triangle& t : methods::floor_mesh(1).triangles)
        mesh.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
    const scene::Scene scene = methods::scene_of({mesh});
    const PatchOptions exact{.crease_rad = kCrease_rad};
    const PatchOptions wide{.crease_rad = kCrease_rad, .weld_epsilon = 1e-3};
    EXPECT_EQ(distinct(surface_ids(scene, IdSource::patch, exact)), 2U);
    EXPECT_EQ(distinct(surface_ids(scene, IdSource::patch, wide)), 1U);
}

bool has_line(const edge::EdgeImage& image) {
    return std::any_of(image.data(), image.data() + image.size(), [](int s) { return s > 0; });
}

/// `scene` from above, all of the image within it.
edge::EdgeImage from_above(const scene::Scene& scene,
                           const std::string& method,
                           const core::ParamValues& values) {
    return methods::drawn(
        method, values, scene, {methods::view_from(scene, {1, 2, 0.01}, {1, 0, 0}, {80, 40}), 1});
}

TEST(Ids, FollowAPatchThatComesApart) {
    // The other tile is lifted on its far side by 60 degrees.
    scene::Scene bent = two_tiles();
    const glm::dmat4 lift = glm::rotate(glm::dmat4(1), glm::radians(60.0), {0, 0, 1});
    bent.instances[1].world_from_object =
        glm::translate(glm::dmat4(1), {1, 0, 0}) * lift * glm::translate(glm::dmat4(1), {1, 0, 0});
    const auto method = methods::find_method("ids").make({{"of", "patch"}});
    const scene::View view = methods::view_from(bent, {1, 2, 0.01}, {1, 0, 0}, {80, 40});
    edge::EdgeImage flat(80, 40);
    edge::EdgeImage lifted(80, 40);
    method->prepare(two_tiles());
    method->pose(two_tiles());
    method->draw({view, 1}, flat);
    method->pose(bent);
    method->draw({view, 1}, lifted);
    EXPECT_FALSE(has_line(flat));
    EXPECT_TRUE(has_line(lifted));
}

/// One object: a low square, and a smaller one above it. Seen from above it fills the image.
scene::Scene raised_square() {
    scene::Mesh mesh = methods::floor_mesh(3);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& p : methods::floor_mesh(0.3F).positions)
        mesh.positions.push_back(p + glm::vec3(1, 0.5F, 0));
    for (const scene::Triangle& t : methods::floor_mesh(1).triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return methods::scene_of({mesh});
}

TEST(JumpFloodMethod, SeesAJumpOfDepthWithinOneIdIfAsked) {
    const scene::Scene scene = raised_square();
    EXPECT_FALSE(
        has_line(from_above(scene, "jump_flood", {{"of", "object"}, {"depth_step", "0"}})));
    EXPECT_TRUE(
        has_line(from_above(scene, "jump_flood", {{"of", "object"}, {"depth_step", "0.1"}})));
    // 1/2 against 1/1.5: a quarter of the nearer's.
    EXPECT_TRUE(
        has_line(from_above(scene, "jump_flood", {{"of", "object"}, {"depth_step", "0.24"}})));
    EXPECT_FALSE(
        has_line(from_above(scene, "jump_flood", {{"of", "object"}, {"depth_step", "0.26"}})));
}

}  // namespace
}  // namespace ink::buffers
