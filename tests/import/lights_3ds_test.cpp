#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include "import/stage_3ds.h"
#include "tests/import/files_3ds.h"
#include "tests/import/model_files.h"

namespace ink::import {
namespace {

using testing::ElementsAre;
using ThreeDsLights = ModelFiles;

using Three = std::array<float, 3>;

/// A light at (1, 2, 3) in a named object of its own.
std::string lamp(const std::string& name, const std::string& chunks) {
    return object_3ds(name, chunk(0x4600, raw(Three{1, 2, 3}) + chunks));
}

const std::string kOrange = chunk(0x0010, raw(Three{1, 0.5F, 0}));
const std::string kThinsOut = chunk(0x4625, "");
const std::string kRanges = chunk(0x4659, raw(4.0F)) + chunk(0x465a, raw(10.0F));

/// Where the triangle stands, as files with a keyframer have it.
const std::string kTriangleNode = node_3ds(0xb002, "T", -1, track_3ds(0xb020, {{0, {0, 0, 0}}}));

std::vector<ImportedLight> lights_in(const std::string& content) {
    return read_3ds_lights(std::as_bytes(std::span<const char>(content)));
}

TEST(ThreeDsLight, HasPlaceColourMultiplierAndRanges) {
    const auto lights =
        lights_in(file_3ds(lamp("Lamp", kOrange + kThinsOut + kRanges + chunk(0x465b, raw(0.5F)))));
    ASSERT_EQ(lights.size(), 1U);
    EXPECT_EQ(lights[0].kind, LightKind::point);
    EXPECT_EQ(lights[0].p_world, glm::dvec3(1, 2, 3));
    EXPECT_EQ(lights[0].color, glm::vec3(0.5F, 0.25F, 0));
    EXPECT_EQ(lights[0].inner_range, 4);
    EXPECT_EQ(lights[0].range, 10);
    EXPECT_FALSE(lights[0].is_physical);
}

TEST(ThreeDsLight, RangesHoldOnlyIfItThinsOut) {
    const auto lights = lights_in(file_3ds(lamp("Lamp", kOrange + kRanges)));
    ASSERT_EQ(lights.size(), 1U);
    EXPECT_EQ(lights[0].range, 0);
    EXPECT_EQ(lights[0].inner_range, 0);
}

TEST(ThreeDsLight, ColoursMayBeBytes) {
    const auto lights =
        lights_in(file_3ds(lamp("Lamp", chunk(0x0011, std::string("\xff\x00\x33", 3)))));
    ASSERT_EQ(lights.size(), 1U);
    EXPECT_EQ(lights[0].color, glm::vec3(1, 0, 0.2F));
}

TEST(ThreeDsLight, OneThatIsOffIsNoneAndASpotSaysSo) {
    const std::string spot = chunk(0x4610, raw(std::array<float, 5>{0, 0, 0, 40, 45}));
    const auto lights =
        lights_in(file_3ds(lamp("off", chunk(0x4620, "")) + lamp("spot", kOrange + spot)));
    ASSERT_EQ(lights.size(), 1U);
    EXPECT_EQ(lights[0].kind, LightKind::spot);
}

TEST(ThreeDsLight, DamageEndsTheSearch) {
    const std::string whole = file_3ds(lamp("Lamp", kOrange + kThinsOut + kRanges));
    for (std::size_t size = 0; size < whole.size(); ++size) {
        for (const ImportedLight& light : lights_in(whole.substr(0, size)))
            EXPECT_EQ(light.p_world, glm::dvec3(1, 2, 3)) << size;
    }
}

TEST_F(ThreeDsLights, StandInTheSceneWithTheirRanges) {
    const scene::Scene scene = import_scene(write(
        "lit.3ds", file_3ds(triangle_3ds("T") + lamp("Lamp", kOrange + kThinsOut + kRanges))));
    ASSERT_EQ(scene.lights.size(), 1U);
    // The file's z is up, the scene's y is.
    EXPECT_LT(glm::length(scene.lights[0].p_world - glm::dvec3(1, 3, -2)), 1e-6);
    EXPECT_EQ(scene.lights[0].color, glm::vec3(1, 0.5F, 0));
    EXPECT_NEAR(scene.lights[0].range, 10, 1e-6);
    EXPECT_NEAR(scene.lights[0].inner_range, 4, 1e-6);
    EXPECT_TRUE(scene.file.notes.empty());
}

TEST_F(ThreeDsLights, GoAndTurnColourByTheirKeys) {
    const std::string tracks = track_3ds(0xb020, {{0, {1, 2, 3}}, {30, {5, 2, 3}}}) +
                               track_3ds(0xb025, {{0, {1, 0, 0}}, {60, {0, 0, 1}}});
    scene::Scene scene = import_scene(
        write("moving.3ds",
              file_3ds(triangle_3ds("T") + lamp("Lamp", kOrange + chunk(0x465b, raw(0.5F))),
                       kTriangleNode + node_3ds(0xb005, "Lamp", -1, tracks))));
    ASSERT_EQ(scene.lights.size(), 1U);
    ASSERT_NE(scene.animation, nullptr);
    EXPECT_EQ(scene.animation->duration_s, 2);
    scene::pose_scene(scene, 0.5);
    EXPECT_LT(glm::length(scene.lights[0].p_world - glm::dvec3(3, 3, -2)), 1e-6);
    EXPECT_EQ(scene.lights[0].color, glm::vec3(0.375F, 0, 0.125F)) << "a quarter of the way";
    scene::pose_scene(scene, 2);
    EXPECT_LT(glm::length(scene.lights[0].p_world - glm::dvec3(5, 3, -2)), 1e-6);
    EXPECT_EQ(scene.lights[0].color, glm::vec3(0, 0, 0.5F));
}

TEST_F(ThreeDsLights, NeedNoNodeOfTheKeyframer) {
    const scene::Scene scene = import_scene(
        write("bare.3ds", file_3ds(triangle_3ds("T") + lamp("Lamp", kOrange), kTriangleNode)));
    EXPECT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.animation, nullptr);
}

TEST_F(ThreeDsLights, WhatIsNotHeededIsNoted) {
    const std::string spot = chunk(0x4610, raw(std::array<float, 5>{0, 0, 0, 40, 45}));
    const std::string tracks = track_3ds(0xb020, {{0, {1, 2, 3}}, {30, {5, 2, 3}}});
    scene::Scene scene = import_scene(write(
        "notes.3ds",
        file_3ds(
            triangle_3ds("T") + lamp("Lamp", kOrange + spot + chunk(0x4654, std::string("T\0", 2))),
            kTriangleNode + node_3ds(0xb007, "Lamp", 0, tracks))));
    ASSERT_EQ(scene.lights.size(), 1U);
    const glm::dvec3 p_world = scene.lights[0].p_world;
    scene::pose_scene(scene, 1);
    EXPECT_EQ(scene.lights[0].p_world, p_world);
    EXPECT_THAT(scene.file.notes,
                ElementsAre("lights that hang on an object and do not go with it: 1",
                            "lights that shine on the objects that they exclude, too: 1",
                            "1 spotlight shines to all sides"));
}

}  // namespace
}  // namespace ink::import
