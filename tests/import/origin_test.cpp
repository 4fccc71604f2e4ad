// What lies far from its coordinates' zero is moved there before it is rounded to floats.

#include "import/imported_scene.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/animation.h"
#include "scene/topology.h"
#include "tests/import/imported_meshes.h"

namespace ink::import {
namespace {

const glm::dvec3 kFar{691'004.25, 0, 5'335'012.7};

/// A cube of 2 m whose vertices stand at `place`.
ImportReply cube_at(const glm::dvec3& place) {
    ImportReply reply = cube_reply();
    for (glm::dvec3& p : reply.meshes[0].positions)
        p += place;
    return reply;
}

/// Two that share a side.
ImportReply two_cubes_at(const glm::dvec3& place) {
    ImportReply reply = cube_at(place);
    reply.meshes.push_back(cube_at(place).meshes[0]);
    for (glm::dvec3& p : reply.meshes[1].positions)
        p.x += 2;
    reply.instances.push_back({1, glm::dmat4(1), "beside"});
    return reply;
}

/// Every corner in the file's own coordinates.
std::vector<glm::dvec3> file_corners(const scene::Scene& scene) {
    std::vector<glm::dvec3> corners;
    for (const scene::Instance& instance : scene.instances)
        for (const glm::vec3& p : scene.meshes[instance.mesh].positions)
            corners.push_back(scene.origin + scene::to_world(instance, p));
    return corners;
}

void expect_near(const std::vector<glm::dvec3>& got,
                 const std::vector<glm::dvec3>& wanted,
                 double distance) {
    ASSERT_EQ(got.size(), wanted.size());
    for (std::size_t i = 0; i < got.size(); ++i)
        EXPECT_LE(glm::distance(got[i], wanted[i]), distance) << i;
}

TEST(Origin, SceneNearZeroStaysAsItIs) {
    for (const double distance : {0.0, 1.0, 2.5}) {
        const scene::Scene scene = scene_from(cube_at({distance, 0, 0}));
        EXPECT_EQ(scene.origin, glm::dvec3(0)) << distance;
        EXPECT_EQ(scene.meshes[0].positions[7], glm::vec3(1 + distance, 1, 1));
        EXPECT_EQ(scene.meshes[0].rounding, 0);
    }
}

TEST(Origin, FarSceneKeepsItsDigits) {
    const ImportReply reply = cube_at(kFar);
    const std::vector<glm::dvec3> wanted = reply.meshes[0].positions;
    const scene::Scene scene = scene_from(reply);
    EXPECT_EQ(scene.origin.y, 0) << "that axis is not far";
    EXPECT_LT(glm::distance(scene.origin, kFar), 4);
    expect_near(file_corners(scene), wanted, 1e-6);
    EXPECT_EQ(scene.instances[0].world_from_object, glm::dmat4(1));
}

/// Two solids that touch, in coordinates that floats do not hold, moved by so many of their
/// diameters.
TEST(Origin, WhereverTheFileHasItAModelKeepsItsShape) {
    const auto at = [](double diameters) {
        const glm::dvec3 place = diameters * glm::dvec3(5.7, -5.7, 5.7);
        return std::pair(scene_from(two_cubes_at(place + glm::dvec3(0.1))), place);
    };
    const std::vector<glm::dvec3> wanted = file_corners(at(0).first);
    for (const double diameters : {1.0, 7.0, 31.0, 1000.0}) {
        SCOPED_TRACE(diameters);
        const auto [scene, place] = at(diameters);
        std::vector<glm::dvec3> corners = file_corners(scene);
        for (glm::dvec3& p : corners)
            p -= place;
        expect_near(corners, wanted, 5e-7);
        EXPECT_EQ(scene::weld(scene).p_world.size(), 12U);
    }
}

TEST(Origin, PartsThatTouchGoOnTouching) {
    // In coordinates that no float holds.
    EXPECT_EQ(scene::weld(scene_from(two_cubes_at(kFar))).p_world.size(), 12U);
}

TEST(Origin, NodesCarryWhatIsFar) {
    // The cubes are near zero in their own space: their floats must stay the file's.
    ImportReply reply = cube_at({0.1, 0, 0});
    reply.meshes[0].are_floats = true;
    const glm::dmat4 first = glm::translate(glm::dmat4(1), kFar);
    reply.instances = {{0, first, "first"}, {0, glm::translate(first, {3.3125, 0, 0}), "second"}};
    const std::vector<glm::dvec3> local = reply.meshes[0].positions;
    const scene::Scene scene = scene_from(reply);
    EXPECT_NE(scene.origin, glm::dvec3(0));
    for (std::size_t v = 0; v < local.size(); ++v)
        EXPECT_EQ(scene.meshes[0].positions[v], glm::vec3(local[v]));
    const std::vector<glm::dvec3> corners = file_corners(scene);
    EXPECT_NEAR(corners[8].x - corners[0].x, 3.3125, 1e-9);
    EXPECT_EQ(scene.meshes[0].rounding, 0);
}

TEST(Origin, FloatsOfTheFileLoseNothingAndKeepTheirRounding) {
    ImportReply reply = cube_at(kFar);
    std::vector<glm::dvec3> wanted;
    for (glm::dvec3& p : reply.meshes[0].positions)
        wanted.push_back(p = glm::dvec3(glm::vec3(p)));
    reply.meshes[0].are_floats = true;
    const scene::Scene scene = scene_from(reply);
    expect_near(file_corners(scene), wanted, 0);
    EXPECT_EQ(scene.meshes[0].rounding, 0.25) << "half a unit in the last place of 5,335,012";
    for (const double rounding : scene::weld(scene).rounding_world)
        EXPECT_GE(rounding, 0.25);
}

TEST(Origin, CamerasGoWithTheScene) {
    ImportReply reply = cube_at(kFar);
    reply.cameras = {{"eye", kFar + glm::dvec3(0, 0, 8), kFar, {0, 1, 0}, 0.7}};
    const scene::Scene scene = scene_from(reply);
    ASSERT_EQ(scene.cameras.size(), 1U);
    EXPECT_LE(glm::distance(scene.origin + scene.cameras[0].eye_world, kFar + glm::dvec3(0, 0, 8)),
              1e-9);
}

TEST(Origin, WhatMovesGoesOnMovingThere) {
    ImportReply reply = cube_at({0, 0, 0});
    scene::Animation motion;
    motion.duration_s = 1;
    motion.nodes = {mover(kFar, kFar + glm::dvec3(1, 0, 0), 1)};
    motion.node_of_instance = {0};
    reply.instances[0].world_from_object = motion.nodes[0].parent_from_node;
    reply.animation = motion;
    scene::Scene scene = scene_from(reply);
    scene::pose_scene(scene, 1);
    const std::vector<glm::dvec3> corners = file_corners(scene);
    EXPECT_LE(glm::distance(corners[0], kFar + glm::dvec3(1, 0, 0) + glm::dvec3(-1)), 1e-9);
}

TEST(Origin, BonesTakeTheirMeshAlong) {
    // Bound far out: what a float holds there is half a metre.
    ImportReply reply = cube_at(kFar);
    scene::Animation motion;
    motion.nodes.resize(1);
    motion.node_of_instance = {scene::kNoNode};
    scene::Skin skin;
    skin.bones = {{0, glm::dmat4(1)}};
    scene::set_weights(std::vector<std::vector<scene::BoneWeight>>(8, {{0, 1.0F}}), skin);
    motion.skins = {skin};
    reply.animation = motion;
    const std::vector<glm::dvec3> wanted = reply.meshes[0].positions;
    expect_near(file_corners(scene_from(reply)), wanted, 1e-6);
}

}  // namespace
}  // namespace ink::import
