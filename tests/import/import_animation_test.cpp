// Keys and bones on their way from a file through the import into a pose.

#include <gmock/gmock.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/animation.h"
#include "tests/import/glb_files.h"
#include "tests/import/model_files.h"

namespace ink::import {
namespace {

using ImportAnimation = ModelFiles;

/// A file with one mesh, a triangle (0,0,0) (1,0,0) (0,1,0); its nodes, a list, are all shown.
GlbFile triangle_file(const Json& nodes) {
    GlbFile file;
    const std::size_t positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    file.put("meshes", {{"primitives", {{{"attributes", {{"POSITION", positions}}}}}}});
    file.json["nodes"] = nodes;
    return file;
}

/// Moves a node by 8 along y in 2 s.
void lift(GlbFile& file, std::size_t node, float y = 8) {
    animate(file, node, "translation", file.accessor<float>({0, 0, 0, 0, y, 0}, "VEC3"), {0, 2});
}

TEST_F(ImportAnimation, GltfNodesMoveByTheirKeys) {
    GlbFile file = triangle_file({{{"name", "lift"}, {"children", {1}}},
                                  {{"name", "cabin"}, {"mesh", 0}, {"translation", {1, 0, 0}}},
                                  {{"name", "still"}, {"mesh", 0}}});
    file.json["scenes"] = {{{"nodes", {0, 2}}}};
    lift(file, 0);
    scene::Scene scene = import_scene(write("moving.glb", file.bytes()));
    ASSERT_NE(scene.animation, nullptr);
    EXPECT_NEAR(scene.animation->duration_s, 2, 1e-9);
    ASSERT_EQ(scene.instances.size(), 2U);
    const auto x1 = [&](std::size_t i) { return scene::to_world(scene.instances[i], {1, 0, 0}); };
    EXPECT_EQ(x1(0), glm::dvec3(2, 0, 0)) << "at rest";
    scene::pose_scene(scene, 0.5);
    EXPECT_LT(glm::length(x1(0) - glm::dvec3(2, 2, 0)), 1e-9);
    EXPECT_EQ(x1(1), glm::dvec3(1, 0, 0));
    scene::pose_scene(scene, 2);
    EXPECT_LT(glm::length(x1(0) - glm::dvec3(2, 8, 0)), 1e-9);
}

TEST_F(ImportAnimation, GltfSkinsBend) {
    // The mesh's own node stands far off, which must not matter.
    GlbFile file =
        triangle_file({{{"name", "body"}, {"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}},
                       {{"name", "a"}, {"children", {2}}},
                       {{"name", "b"}}});
    file.json["scenes"] = {{{"nodes", {0, 1}}}};
    Json& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] =
        file.accessor<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4");
    attributes["WEIGHTS_0"] =
        file.accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0}, "VEC4");
    std::vector<float> binds;
    for (int i = 0; i < 32; ++i)
        binds.push_back(i % 16 % 5 == 0 ? 1.0F : 0.0F);
    file.put("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", file.accessor(binds, "MAT4")}});
    animate(file, 2, "translation", file.accessor<float>({0, 0, 0, 0, 0, 4}, "VEC3"), {0, 1});
    scene::Scene scene = import_scene(write("skinned.glb", file.bytes()));
    ASSERT_NE(scene.animation, nullptr);
    ASSERT_EQ(scene.animation->skins.size(), 1U);
    const auto corner = [&](std::size_t v) {
        return scene::to_world(scene.instances.at(0), scene.meshes.at(0).positions.at(v));
    };
    EXPECT_LT(glm::length(corner(1) - glm::dvec3(1, 0, 0)), 1e-6);
    scene::pose_scene(scene, 1);
    EXPECT_LT(glm::length(corner(0) - glm::dvec3(0, 0, 0)), 1e-6);
    EXPECT_LT(glm::length(corner(1) - glm::dvec3(1, 0, 4)), 1e-6);
    EXPECT_LT(glm::length(corner(2) - glm::dvec3(0, 1, 2)), 1e-6);
}

TEST_F(ImportAnimation, KeysThatAreNotFiniteAreAMessage) {
    GlbFile file = triangle_file({{{"name", "n"}, {"mesh", 0}}});
    lift(file, 0, NAN);
    EXPECT_THAT(complaint(write("lost.glb", file.bytes())), testing::HasSubstr("is not finite"));
}

TEST_F(ImportAnimation, GltfCamerasRideOnTheirNodes) {
    GlbFile file = triangle_file({{{"name", "lift"}, {"children", {1}}},
                                  {{"name", "rider"}, {"camera", 0}, {"translation", {0, 0, 5}}},
                                  {{"name", "still"}, {"mesh", 0}},
                                  {{"name", "post"}, {"camera", 1}, {"translation", {0, 0, 7}}}});
    file.json["scenes"] = {{{"nodes", {0, 2, 3}}}};
    const Json lens = {{"type", "perspective"},
                       {"perspective", {{"yfov", 0.7}, {"znear", 0.1}, {"aspectRatio", 1}}}};
    file.json["cameras"] = {lens, lens};
    lift(file, 0);
    scene::Scene scene = import_scene(write("ride.glb", file.bytes()));
    ASSERT_EQ(scene.cameras.size(), 2U);
    const bool rider_is_first = scene.cameras[0].name == "rider";
    scene::Camera& rider = scene.cameras[rider_is_first ? 0 : 1];
    scene::Camera& post = scene.cameras[rider_is_first ? 1 : 0];
    EXPECT_LT(glm::length(rider.eye_world - glm::dvec3(0, 0, 5)), 1e-6);
    const glm::dmat3 view_direction = rider.view_from_world;
    scene::pose_scene(scene, 0.5);
    EXPECT_LT(glm::length(rider.eye_world - glm::dvec3(0, 2, 5)), 1e-6);
    EXPECT_LT(glm::length((rider.view_from_world - view_direction)[2]), 1e-6) << "it does not turn";
    EXPECT_LT(glm::length(post.eye_world - glm::dvec3(0, 0, 7)), 1e-6);
    scene::rest_scene(scene);
    EXPECT_LT(glm::length(rider.eye_world - glm::dvec3(0, 0, 5)), 1e-6);
}

TEST_F(ImportAnimation, AFileWithoutKeysHasNone) {
    EXPECT_EQ(import_scene(write("still.obj", kTriangleObj)).animation, nullptr);
}

}  // namespace
}  // namespace ink::import
