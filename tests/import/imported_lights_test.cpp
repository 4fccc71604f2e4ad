#include "import/imported_scene.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>
#include <limits>

#include "tests/import/fbx_files.h"
#include "tests/import/imported_meshes.h"
#include "tests/import/model_files.h"

namespace ink::import {
namespace {

using testing::ElementsAre;
using ImportLights = ModelFiles;

/// A cube about zero with lights.
ImportReply lit_reply(std::vector<ImportedLight> lights) {
    ImportReply reply = cube_reply();
    reply.lights = std::move(lights);
    return reply;
}

scene::Scene lit_by(std::vector<ImportedLight> lights) {
    return scene_from(lit_reply(std::move(lights)));
}

ImportedLight point_at(const glm::dvec3& p_world, const glm::vec3& color) {
    ImportedLight light;
    light.p_world = p_world;
    light.color = color;
    return light;
}

TEST(ImportedLights, SharesOfFullLightStay) {
    ImportedLight lamp = point_at({0, 4, 0}, {0.5F, 0.25F, 0});
    lamp.range = 6;
    const scene::Scene scene = lit_by({lamp});
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.lights[0].p_world, glm::dvec3(0, 4, 0));
    EXPECT_EQ(scene.lights[0].color, glm::vec3(0.5F, 0.25F, 0));
    EXPECT_EQ(scene.lights[0].range, 6);
}

TEST(ImportedLights, TheBrightestOfThoseAboveOneIsOne) {
    const scene::Scene scene =
        lit_by({point_at({0, 4, 0}, {1000, 500, 0}), point_at({0, 5, 0}, {250, 0, 0})});
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(scene.lights[0].color, glm::vec3(1, 0.5F, 0));
    EXPECT_EQ(scene.lights[1].color, glm::vec3(0.25F, 0, 0));
}

TEST(ImportedLights, CandelaCountByWhatArrivesInTheMiddle) {
    // 8 candela 2 away and 8 candela 4 away are 2 and 0.5 lux; the third has 1 lux of its own.
    ImportedLight near = point_at({2, 0, 0}, glm::vec3(8));
    ImportedLight far = point_at({0, 4, 0}, glm::vec3(8));
    ImportedLight sun;
    sun.kind = LightKind::distant;
    sun.direction_world = {0, -3, 0};
    near.is_physical = far.is_physical = sun.is_physical = true;
    const scene::Scene scene = lit_by({near, far, sun});
    ASSERT_EQ(scene.lights.size(), 3U);
    EXPECT_EQ(scene.lights[0].color.r, 1);
    EXPECT_EQ(scene.lights[1].color.r, 0.25F);
    EXPECT_EQ(scene.lights[2].color.r, 0.5F);
}

TEST(ImportedLights, ADistantOneHangsFarAwayAgainstItsDirection) {
    ImportedLight sun;
    sun.kind = LightKind::distant;
    sun.direction_world = {0, -3, 0};
    sun.range = 7;
    const scene::Scene scene = lit_by({sun});
    ASSERT_EQ(scene.lights.size(), 1U);
    const glm::dvec3& p_world = scene.lights[0].p_world;
    EXPECT_GT(p_world.y, 500);
    EXPECT_EQ(p_world, glm::dvec3(0, p_world.y, 0));
    EXPECT_EQ(scene.lights[0].range, 0) << "it reaches everywhere";
}

TEST(ImportedLights, WhatIsNotAsInTheFileIsNoted) {
    ImportedLight spot = point_at({0, 4, 0}, glm::vec3(1));
    spot.kind = LightKind::spot;
    ImportedLight lost = point_at({std::numeric_limits<double>::quiet_NaN(), 0, 0}, glm::vec3(1));
    const scene::Scene scene = lit_by({spot, spot, lost});
    EXPECT_EQ(scene.lights.size(), 2U);
    EXPECT_THAT(scene.file.notes,
                ElementsAre("2 spotlights shine to all sides",
                            "1 light of impossible numbers is not heeded"));
}

TEST(ImportedLights, DarkOnesAreNoneAndManyAreCut) {
    EXPECT_TRUE(lit_by({point_at({0, 4, 0}, glm::vec3(0))}).lights.empty());
    std::vector<ImportedLight> many(100, point_at({0, 4, 0}, glm::vec3(1)));
    const scene::Scene scene = lit_by(many);
    EXPECT_EQ(scene.lights.size(), 64U);
    EXPECT_THAT(scene.file.notes, ElementsAre("36 lights beyond the 64th are not heeded"));
}

/// A cube on node 0, which stands; node 1, which goes from x = 1 to x = 3 in two seconds.
ImportReply moving_reply(std::vector<ImportedLight> lights) {
    ImportReply reply = lit_reply(std::move(lights));
    reply.animation.emplace();
    reply.animation->duration_s = 2;
    reply.animation->nodes = {scene::AnimatedNode{}, mover({1, 0, 0}, {3, 0, 0}, 2)};
    reply.animation->node_of_instance = {0};
    return reply;
}

TEST(ImportedLights, GoWithNodesThatMove) {
    ImportedLight still = point_at({0, 4, 0}, glm::vec3(1));
    still.node = 0;
    ImportedLight moving = point_at({1, 4, 0}, glm::vec3(1));
    moving.node = 1;
    ImportedLight lost = still;
    lost.node = 7;
    scene::Scene scene = scene_from(moving_reply({still, moving, lost}));
    ASSERT_NE(scene.animation, nullptr);
    scene::pose_scene(scene, 2);
    EXPECT_EQ(scene.lights[0].p_world, glm::dvec3(0, 4, 0));
    EXPECT_EQ(scene.lights[1].p_world, glm::dvec3(3, 4, 0));
    EXPECT_EQ(scene.lights[2].p_world, glm::dvec3(0, 4, 0));
    scene::rest_scene(scene);
    EXPECT_EQ(scene.lights[1].p_world, glm::dvec3(1, 4, 0));
}

TEST(ImportedLights, ASceneFarFromZeroTakesItsLightsAlong) {
    ImportReply reply = moving_reply({point_at({1e6 + 1, 4, 0}, glm::vec3(1))});
    reply.lights[0].node = 1;
    for (scene::VectorKey& key : reply.animation->nodes[1].translations)
        key.value.x += 1e6;
    reply.animation->nodes[1].parent_from_node[3].x += 1e6;
    for (scene::AnimatedNode& node : reply.animation->nodes)
        if (!node.has_keys()) node.parent_from_node[3].x = 1e6;
    reply.instances[0].world_from_object[3].x = 1e6;
    scene::Scene scene = scene_from(std::move(reply));
    ASSERT_NE(scene.origin.x, 0);
    EXPECT_EQ(scene.origin.x + scene.lights[0].p_world.x, 1e6 + 1);
    scene::pose_scene(scene, 2);
    EXPECT_EQ(scene.origin.x + scene.lights[0].p_world.x, 1e6 + 3);
}

TEST_F(ImportLights, FbxLightsDecay) {
    fbx::File file;
    file.settings = {fbx::property("UnitScaleFactor", fbx::Numbers{100})};  // metres
    fbx::add_box(file, file.model(0, "box"));
    file.attribute(file.model(0, "L", {fbx::property("Lcl Translation", {1, 2, 3})}, "Light"),
                   "Light",
                   {fbx::property("LightType", 0),
                    fbx::property("Color", {1, 0.5, 0}),
                    fbx::property("Intensity", fbx::Numbers{5000}),
                    fbx::property("DecayType", 2),
                    fbx::property("DecayStart", fbx::Numbers{3})});
    const scene::Scene scene = import_scene(write("lit.fbx", file.text()));
    ASSERT_EQ(scene.lights.size(), 1U);
    const glm::dvec3 p_cm(100, 200, 300);
    EXPECT_LT(glm::length(scene.lights[0].p_world - p_cm), 1e-4);
    EXPECT_EQ(scene.lights[0].color, glm::vec3(1, 0.5F, 0)) << "the brightest has full light";
    EXPECT_NEAR(scene.lights[0].range, 600, 1e-3) << "half of the light is left at 3 m";
}

}  // namespace
}  // namespace ink::import
