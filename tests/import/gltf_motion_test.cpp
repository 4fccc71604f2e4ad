// What moves in glTF 2.0: keys of every course, morph targets, bones.

#include <gmock/gmock.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/animation.h"
#include "tests/core/error_text.h"
#include "tests/import/glb_files.h"
#include "tests/import/model_files.h"
#include "tests/import/solids.h"

namespace ink::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using GltfMotionFile = ModelFiles;

Solid box_at(scene::Scene scene, double time_s) {
    scene::pose_scene(scene, time_s);
    return solid_of(scene);
}

/// A cube that moves along x.
GlbFile moving_cube(const std::vector<float>& places, const std::string& interpolation) {
    GlbFile file = cube_file();
    file.put("nodes", {{"mesh", 0}});
    animate(file, 0, "translation", file.accessor(places, "VEC3"), {0, 1}, interpolation);
    return file;
}

TEST_F(GltfMotionFile, StepsStay) {
    const scene::Scene scene =
        import_scene(write("step.glb", moving_cube({0, 0, 0, 4, 0, 0}, "STEP").bytes()));
    expect_box(box_at(scene, 0.25), {0, 0, 0}, {1, 1, 1});
    expect_box(box_at(scene, 0.999), {0, 0, 0}, {1, 1, 1});
    expect_box(box_at(scene, 1), {4, 0, 0}, {5, 1, 1});
}

TEST_F(GltfMotionFile, CubicSplinesFollowTheirTangents) {
    // In, value, out of each key: appendix C.5 gives 10 * (t - 2 t^2 + t^3) + 4 * (3 t^2 - 2 t^3)
    // - 2 * (t^3 - t^2).
    const GlbFile file =
        moving_cube({9, 9, 9, 0, 0, 0, 10, 0, 0, -2, 0, 0, 4, 0, 0, 9, 9, 9}, "CUBICSPLINE");
    const scene::Scene scene = import_scene(write("cubic.glb", file.bytes()));
    const double x =
        10 * (0.25 - 0.125 + 0.015625) + 4 * (0.1875 - 0.03125) - 2 * (0.015625 - 0.0625);
    expect_box(box_at(scene, 0.25), {x, 0, 0}, {x + 1, 1, 1});
    expect_box(box_at(scene, 1), {4, 0, 0}, {5, 1, 1});
}

TEST_F(GltfMotionFile, CubicRotationsAreMadeUnit) {
    GlbFile file = cube_file();
    file.put("nodes", {{"mesh", 0}});
    const float half = std::sqrt(0.5F);
    const auto turns = file.accessor<float>(
        {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, half, half, 0, 0, 0, 0}, "VEC4");
    animate(file, 0, "rotation", turns, {0, 1}, "CUBICSPLINE");
    scene::Scene scene = import_scene(write("turn.glb", file.bytes()));
    scene::pose_scene(scene, 0.5);
    const glm::dmat3 turn(scene.instances.at(0).world_from_object);
    EXPECT_NEAR(glm::length(turn[0]), 1, 1e-9);
    EXPECT_NEAR(std::atan2(turn[0].y, turn[0].x), std::acos(-1.0) / 4, 1e-6) << "by symmetry";
}

TEST_F(GltfMotionFile, RotationsMayBeNormalisedIntegers) {
    GlbFile file = cube_file();
    file.put("nodes", {{"mesh", 0}});
    const auto turns =
        file.accessor<std::int16_t>({0, 0, 0, 32767, 0, 0, 23170, 23170}, "VEC4", kUnits);
    animate(file, 0, "rotation", turns, {0, 1});
    const scene::Scene scene = import_scene(write("turn.glb", file.bytes()));
    expect_box(box_at(scene, 1), {-1, 0, 0}, {0, 1, 1});
    expect_box(box_at(scene, 0), {0, 0, 0}, {1, 1, 1});
}

/// Gives the file's cube one target, by which it is twice as long along an axis.
void put_target(GlbFile& file, std::size_t axis) {
    std::vector<float> longer(24, 0);
    for (std::size_t v = 0; v < 8; ++v)
        longer[3 * v + axis] = (v >> axis & 1) != 0 ? 1.0F : 0.0F;
    file.json["meshes"][0]["primitives"][0]["targets"] = {
        {{"POSITION", file.accessor(longer, "VEC3")}}};
}

GlbFile growing_cube() {
    GlbFile file = cube_file();
    put_target(file, 1);
    file.put("nodes", {{"mesh", 0}});
    return file;
}

TEST_F(GltfMotionFile, DefaultWeightsShapeTheMesh) {
    GlbFile file = growing_cube();
    const auto box = [&] { return solid_of(import_scene(write("morph.glb", file.bytes()))); };
    expect_box(box(), {0, 0, 0}, {1, 1, 1});
    file.json["meshes"][0]["weights"] = {1};
    expect_box(box(), {0, 0, 0}, {1, 2, 1});
    file.json["nodes"][0]["weights"] = {0.5};
    expect_box(box(), {0, 0, 0}, {1, 1.5, 1});
}

TEST_F(GltfMotionFile, NodesMorphOneMeshEachByItsOwnWeights) {
    GlbFile file = growing_cube();
    file.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
    file.put("nodes", {{"mesh", 0}, {"name", "high"}, {"weights", {1}}});
    file.put("nodes", {{"mesh", 0}, {"name", "high too"}, {"weights", {1}}});
    const scene::Scene scene = import_scene(write("morph.glb", file.bytes()));
    EXPECT_EQ(scene.meshes.size(), 2U) << "one of each shape";
    expect_box(solid_of(scene, "node 0"), {0, 0, 0}, {1, 1, 1});
    expect_box(solid_of(scene, "high"), {0, 0, 0}, {1, 2, 1});
}

TEST_F(GltfMotionFile, WeightsMove) {
    for (const char* interpolation : {"LINEAR", "STEP"}) {
        GlbFile file = growing_cube();
        file.json["meshes"][0]["weights"] = {2};
        animate(file,
                0,
                "weights",
                file.accessor<std::uint8_t>({0, 255, 0}, "SCALAR", kUnits),
                {0, 1, 3},
                interpolation);
        const scene::Scene scene = import_scene(write("morph.glb", file.bytes()));
        ASSERT_NE(scene.animation, nullptr);
        const bool is_step = interpolation[0] == 'S';
        expect_box(solid_of(scene), {0, 0, 0}, {1, 3, 1});  // at rest
        expect_box(box_at(scene, 0), {0, 0, 0}, {1, 1, 1});
        expect_box(box_at(scene, 0.5), {0, 0, 0}, {1, is_step ? 1 : 1.5, 1});
        expect_box(box_at(scene, 2), {0, 0, 0}, {1, is_step ? 2 : 1.5, 1});
        expect_box(box_at(scene, 3), {0, 0, 0}, {1, 1, 1});
    }
}

/// Moves the file's cube 262144 along an axis.
void move_far(GlbFile& file, std::size_t axis) {
    std::vector<float> far = cube_corners<float>();
    for (std::size_t v = 0; v < 8; ++v)
        far[3 * v + axis] += 4096 * 64;
    file.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = file.accessor(far, "VEC3");
}

TEST_F(GltfMotionFile, MorphedMeshesFarOutStayThere) {
    GlbFile file = growing_cube();
    move_far(file, 0);
    animate(file, 0, "weights", file.accessor<float>({0, 1}, "SCALAR"), {0, 1});
    const scene::Scene scene = import_scene(write("far.glb", file.bytes()));
    EXPECT_NE(scene.origin.x, 0);
    expect_box(solid_of(scene), {262144, 0, 0}, {262145, 1, 1});
    expect_box(box_at(scene, 1), {262144, 0, 0}, {262145, 2, 1});
}

TEST_F(GltfMotionFile, MovingNodesOfMeshesFarOutStayThere) {
    GlbFile file = moving_cube({0, 0, 0, 4, 0, 0}, "LINEAR");
    move_far(file, 1);
    const scene::Scene scene = import_scene(write("far.glb", file.bytes()));
    EXPECT_NE(scene.origin.y, 0);
    expect_box(solid_of(scene), {0, 262144, 0}, {1, 262145, 1});
    expect_box(box_at(scene, 1), {4, 262144, 0}, {5, 262145, 1});
}

/// A cube with two joints, nodes 1 and 2, at the origin: its lower corners follow the first.
template <class Joint, class Weight>
GlbFile skinned_cube(Weight one, const Json& units) {
    GlbFile file = cube_file();
    file.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
    std::vector<Joint> joints;
    std::vector<Weight> weights;
    for (int v = 0; v < 8; ++v) {
        joints.insert(joints.end(), {static_cast<Joint>(v >> 1 & 1), 0, 0, 0});
        weights.insert(weights.end(), {one, 0, 0, 0});
    }
    Json& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = file.accessor(joints, "VEC4");
    attributes["WEIGHTS_0"] = file.accessor(weights, "VEC4", units);
    file.put("nodes", {{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}});
    file.put("nodes", {{"name", "a"}});
    file.put("nodes", {{"name", "b"}, {"translation", {0, 2, 0}}});
    file.put("skins", {{"joints", {1, 2}}});
    return file;
}

TEST_F(GltfMotionFile, SkinsWithoutBindMatricesTakeTheIdentity) {
    const Json none = Json::object();
    const auto check = [&](const GlbFile& file) {
        // The mesh's own node stands far off, which must not matter.
        expect_box(solid_of(import_scene(write("skin.glb", file.bytes()))), {0, 0, 0}, {1, 3, 1});
    };
    check(skinned_cube<std::uint8_t, float>(1, none));
    check(skinned_cube<std::uint16_t, std::uint8_t>(255, kUnits));
    check(skinned_cube<std::uint8_t, std::uint16_t>(65535, kUnits));
}

TEST_F(GltfMotionFile, BindMatricesComeBeforeTheJoints) {
    GlbFile file = skinned_cube<std::uint8_t, float>(1, Json::object());
    std::vector<float> binds;
    for (int joint = 0; joint < 2; ++joint)
        for (int i = 0; i < 16; ++i)
            binds.push_back(i % 5 == 0 ? 1.0F : joint == 1 && i == 13 ? -2.0F : 0.0F);
    file.json["skins"][0]["inverseBindMatrices"] = file.accessor(binds, "MAT4");
    expect_box(solid_of(import_scene(write("skin.glb", file.bytes()))), {0, 0, 0}, {1, 1, 1});
}

TEST_F(GltfMotionFile, FurtherSetsOfJointsCount) {
    GlbFile file = skinned_cube<std::uint8_t, float>(0.5F, Json::object());
    std::vector<std::uint8_t> joints;
    for (int v = 0; v < 8; ++v)
        joints.insert(joints.end(), {1, 0, 0, 9});  // the last has no weight
    Json& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_1"] = file.accessor(joints, "VEC4");
    attributes["WEIGHTS_1"] = attributes["WEIGHTS_0"];
    // Half way between the joints below, wholly with the second above.
    expect_box(solid_of(import_scene(write("skin.glb", file.bytes()))), {0, 1, 0}, {1, 3, 1});
}

TEST_F(GltfMotionFile, EachNodeGoesByItsOwnSkin) {
    GlbFile file = skinned_cube<std::uint8_t, float>(1, Json::object());
    file.json["scenes"] = {{{"nodes", {0, 1, 2, 3, 4}}}};
    file.put("nodes", {{"mesh", 0}, {"skin", 1}});
    file.put("nodes", {{"name", "c"}, {"translation", {4, 0, 0}}});
    file.put("skins", {{"joints", {4, 4}}});
    const scene::Scene scene = import_scene(write("two.glb", file.bytes()));
    EXPECT_EQ(scene.meshes.size(), 2U);
    expect_box(solid_of(scene, "node 0"), {0, 0, 0}, {1, 3, 1});
    expect_box(solid_of(scene, "node 3"), {4, 0, 0}, {5, 1, 1});
}

TEST_F(GltfMotionFile, BonesTakeWhatMorphsMade) {
    GlbFile file = skinned_cube<std::uint8_t, float>(1, Json::object());
    put_target(file, 0);
    animate(file, 0, "weights", file.accessor<float>({0, 1}, "SCALAR"), {0, 1});
    const scene::Scene scene = import_scene(write("both.glb", file.bytes()));
    expect_box(solid_of(scene), {0, 0, 0}, {1, 3, 1});
    expect_box(box_at(scene, 0.5), {0, 0, 0}, {1.5, 3, 1});
    expect_box(box_at(scene, 1), {0, 0, 0}, {2, 3, 1});
}

TEST_F(GltfMotionFile, DeepChainsOfJointsPose) {
    constexpr int kLevels = 500;
    GlbFile file = cube_file();
    Json nodes = Json::array({{{"children", {1}}}});
    for (int level = 1; level <= kLevels; ++level) {
        nodes.push_back({{"translation", {0, 0.125, 0}}, {"rotation", {0, 0, 0, 1}}});
        if (level < kLevels) nodes.back()["children"] = {level + 1};
    }
    nodes.back()["mesh"] = 0;
    file.json["nodes"] = nodes;
    animate(file, 0, "translation", file.accessor<float>({0, 0, 0, 1, 0, 0}, "VEC3"), {0, 1});
    // Every level turns there and back.
    Json& channels = file.json["animations"][0]["channels"];
    file.json["animations"][0]["samplers"].push_back(
        {{"input", file.json["animations"][0]["samplers"][0]["input"]},
         {"output", file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1}, "VEC4")}});
    for (int level = 1; level <= kLevels; ++level)
        channels.push_back({{"sampler", 1}, {"target", {{"node", level}, {"path", "rotation"}}}});
    const scene::Scene scene = import_scene(write("chain.glb", file.bytes()));
    expect_box(box_at(scene, 1), {1, 62.5, 0}, {2, 63.5, 1});
}

TEST_F(GltfMotionFile, AnimationsAreChosenByNameOrNumber) {
    GlbFile file = moving_cube({0, 0, 0, 4, 0, 0}, "LINEAR");
    file.json["animations"][0]["name"] = "Walk";
    animate(file, 0, "scale", file.accessor<float>({1, 1, 1, 3, 1, 1}, "VEC3"), {0, 1});
    file.json["animations"][1]["name"] = "Grow";
    const auto path = write("several.glb", file.bytes());
    const auto chosen = [&](const std::string& animation) {
        return import_scene(path, {.animation = animation});
    };
    expect_box(box_at(chosen(""), 1), {4, 0, 0}, {5, 1, 1});
    expect_box(box_at(chosen("Grow"), 1), {0, 0, 0}, {3, 1, 1});
    expect_box(box_at(chosen("1"), 1), {0, 0, 0}, {3, 1, 1});
    EXPECT_THAT(chosen("Grow").file.animation_names, ElementsAre("Walk", "Grow"));
    EXPECT_THAT(chosen("Grow").file.notes, ElementsAre("1 further animation: Walk"));
    EXPECT_THAT(core::error_text([&] { return chosen("Run"); }),
                HasSubstr("it has no animation \"Run\" (accepted: Walk, Grow, or a number, 0..1)"));
}

TEST_F(GltfMotionFile, PointersAtNodesAreChannelsOthersAreNotedOrRefused) {
    GlbFile file = moving_cube({0, 0, 0, 4, 0, 0}, "LINEAR");
    const auto point_at = [&](const std::string& pointer) {
        file.json["animations"][0]["channels"][0]["target"] = {
            {"path", "pointer"},
            {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
        return write("pointer.glb", file.bytes());
    };
    expect_box(box_at(import_scene(point_at("/nodes/0/translation")), 1), {4, 0, 0}, {5, 1, 1});
    const char* visible = "/nodes/0/extensions/KHR_node_visibility/visible";
    EXPECT_THAT(import_scene(point_at(visible)).file.notes,
                ElementsAre("1 channel of the animation at no node"));
    file.json["extensionsRequired"] = {"KHR_animation_pointer"};
    EXPECT_THAT(complaint(point_at(visible)), HasSubstr("KHR_animation_pointer at /nodes/0"));
    EXPECT_THAT(import_scene(point_at("/materials/0/alphaCutoff")).file.notes,
                ElementsAre("1 channel of the animation at no node"));
}

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

TEST_F(GltfMotionFile, NodesMoveByTheirKeys) {
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

TEST_F(GltfMotionFile, SkinsBend) {
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

TEST_F(GltfMotionFile, KeysThatAreNotFiniteAreAMessage) {
    GlbFile file = triangle_file({{{"name", "n"}, {"mesh", 0}}});
    lift(file, 0, NAN);
    EXPECT_THAT(complaint(write("lost.glb", file.bytes())), testing::HasSubstr("is not finite"));
}

TEST_F(GltfMotionFile, CamerasRideOnTheirNodes) {
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

TEST_F(GltfMotionFile, AFileWithoutKeysHasNone) {
    EXPECT_EQ(import_scene(write("still.obj", kTriangleObj)).animation, nullptr);
}

}  // namespace
}  // namespace ink::import
