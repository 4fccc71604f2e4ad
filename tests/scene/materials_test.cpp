#include "scene/materials.h"

#include <gtest/gtest.h>

#include <memory>

#include "scene/animation.h"
#include "scene/topology.h"
#include "tests/scene/edge_counts.h"
#include "tests/scene/small_meshes.h"

namespace ink::scene {
namespace {

/// A cube whose first two sides have another material.
Scene cube_of_two() {
    Scene scene = scene_of(unit_cube());
    scene.meshes[0].materials.assign(12, 7);
    for (std::size_t t = 0; t < 4; ++t)
        scene.meshes[0].materials[t] = 3;
    return scene;
}

TEST(Materials, EachBecomesAnObject) {
    Scene scene = cube_of_two();
    split_materials(scene);
    ASSERT_EQ(scene.instances.size(), 2U);
    EXPECT_EQ(scene.instances[0].name, "only/material 3");
    EXPECT_EQ(scene.instances[1].name, "only/material 7");
    EXPECT_EQ(scene.meshes[scene.instances[0].mesh].triangles.size(), 4U);
    EXPECT_EQ(scene.meshes[scene.instances[1].mesh].triangles.size(), 8U);
    EXPECT_NO_THROW(check_scene(scene));
}

TEST(Materials, SurfaceStaysTheSame) {
    Scene scene = cube_of_two();
    const Topology before = weld(scene);
    split_materials(scene);
    const Topology after = weld(scene);
    EXPECT_EQ(after.p_world.size(), before.p_world.size());
    EXPECT_EQ(after.edges.size(), before.edges.size());
    EXPECT_EQ(edge_counts(after).boundary, 0U);
}

TEST(Materials, ObjectOfOneStaysAsItIs) {
    Scene scene = scene_of(unit_cube());
    scene.instances.push_back(scene.instances[0]);
    const std::uint64_t hash = scene_hash(scene);
    split_materials(scene);
    EXPECT_EQ(scene_hash(scene), hash);
    EXPECT_EQ(scene.instances[1].name, "only");
}

TEST(Materials, WhatMovesGoesOnMoving) {
    Scene scene = cube_of_two();
    Animation motion;
    motion.duration_s = 1;
    motion.frames_per_s = 1;
    motion.node_of_instance = {kNoNode};
    VertexFrames frames;
    frames.frame_count = 2;
    frames.positions = scene.meshes[0].positions;
    for (const glm::vec3& p : scene.meshes[0].positions)
        frames.positions.push_back(p + glm::vec3(5, 0, 0));
    motion.vertex_frames = {frames};
    scene.animation = std::make_shared<Animation>(motion);
    split_materials(scene);
    EXPECT_NO_THROW(check_animation(scene, *scene.animation));
    pose_scene(scene, 1);
    const Sphere bounds = bounding_sphere(scene);
    EXPECT_NEAR(bounds.center_world.x, 5, 1e-6);
    EXPECT_EQ(edge_counts(weld(scene)).boundary, 0U) << "both parts have moved";
}

}  // namespace
}  // namespace ink::scene
