#include "scene/animation.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/error.h"
#include "tests/scene/small_meshes.h"

namespace ink::scene {
namespace {

constexpr double kHalfRoot = 0.70710678118654752;  // sin and cos of 45 degrees

/// A cube whose node moves from (1,2,3) to (5,2,3), grows twofold along y and turns by 90 degrees
/// about z, between the seconds 1 and 3; a second cube hangs on it, 10 above.
Scene moving_cubes() {
    Scene scene;
    scene.name = "moving";
    scene.meshes = {unit_cube()};
    scene.instances = {{0, glm::dmat4(1), "mover"}, {0, glm::dmat4(1), "rider"}};
    Animation animation;
    animation.duration_s = 4;
    AnimatedNode mover;
    mover.translations = {{1, {1, 2, 3}}, {3, {5, 2, 3}}};
    mover.rotations = {{1, {1, 0, 0, 0}}, {3, {kHalfRoot, 0, 0, kHalfRoot}}};
    mover.scales = {{1, {1, 1, 1}}, {3, {1, 2, 1}}};
    AnimatedNode rider;
    rider.parent = 0;
    rider.parent_from_node[3] = {0, 10, 0, 1};
    animation.nodes = {mover, rider};
    animation.node_of_instance = {0, 1};
    scene.animation = std::make_shared<const Animation>(animation);
    return scene;
}

glm::dvec3 origin_of(const Scene& scene, std::size_t instance) {
    return to_world(scene.instances[instance], {0, 0, 0});
}

void expect_near(const glm::dvec3& found, const glm::dvec3& expected, double tolerance = 1e-12) {
    EXPECT_LT(glm::length(found - expected), tolerance)
        << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(Animation, PosesAtKeysEqualTheKeys) {
    Scene scene = moving_cubes();
    for (const double before : {0.0, 1.0}) {
        pose_scene(scene, before);
        EXPECT_EQ(origin_of(scene, 0), glm::dvec3(1, 2, 3));
        EXPECT_EQ(origin_of(scene, 1), glm::dvec3(1, 12, 3));
    }
    for (const double after : {3.0, 4.0, 99.0}) {
        pose_scene(scene, after);
        EXPECT_EQ(origin_of(scene, 0), glm::dvec3(5, 2, 3));
        expect_near(to_world(scene.instances[0], {1, 0, 0}), {5, 3, 3});
        // 10 along the mover's y, which is twice as long and lies along -x now.
        expect_near(origin_of(scene, 1), {5 - 20, 2, 3});
    }
}

TEST(Animation, HalfwayIsTheMeanAndHalfTheTurn) {
    Scene scene = moving_cubes();
    pose_scene(scene, 2);
    expect_near(origin_of(scene, 0), {3, 2, 3});
    expect_near(to_world(scene.instances[0], {1, 0, 0}), {3 + kHalfRoot, 2 + kHalfRoot, 3});
    expect_near(to_world(scene.instances[0], {0, 1, 0}),
                {3 - 1.5 * kHalfRoot, 2 + 1.5 * kHalfRoot, 3});
}

TEST(Animation, AnyShareOfATurnIsThatAngle) {
    const glm::dquat none(1, 0, 0, 0);
    const double half_rad = 0.6;
    const glm::dquat turn(std::cos(half_rad), 0, std::sin(half_rad), 0);
    for (const double share : {0.0, 1e-9, 0.1, 1.0 / 3, 0.5, 0.77, 1 - 1e-9, 1.0}) {
        const glm::dquat part = slerp(none, turn, share);
        EXPECT_NEAR(part.w, std::cos(half_rad * share), 1e-15);
        EXPECT_NEAR(part.y, std::sin(half_rad * share), 1e-15);
    }
    // The same rotation with the other sign is no detour.
    EXPECT_NEAR(slerp(none, -turn, 0.5).y, std::sin(half_rad / 2), 1e-15);
}

TEST(Animation, PosingTwiceAndBackGivesTheSameBits) {
    Scene scene = moving_cubes();
    pose_scene(scene, 1.7);
    const std::uint64_t there = scene_hash(scene);
    pose_scene(scene, 2.9);
    EXPECT_NE(scene_hash(scene), there);
    pose_scene(scene, 1.7);
    EXPECT_EQ(scene_hash(scene), there);
}

TEST(Animation, RestIsWhatTheNodesSayWithoutTheirKeys) {
    Scene scene = moving_cubes();
    pose_scene(scene, 3);
    rest_scene(scene);
    EXPECT_EQ(origin_of(scene, 0), glm::dvec3(0, 0, 0));
    EXPECT_EQ(origin_of(scene, 1), glm::dvec3(0, 10, 0));
}

TEST(Animation, ASceneWithoutOneStaysAsItIs) {
    Scene scene = moving_cubes();
    scene.animation.reset();
    const std::uint64_t before = scene_hash(scene);
    pose_scene(scene, 2);
    rest_scene(scene);
    EXPECT_EQ(scene_hash(scene), before);
}

/// A triangle of three frames at 2 a second, and one beside it of two.
Scene framed_triangles() {
    Scene scene = small_triangles(2);
    Animation animation;
    animation.duration_s = 1;
    animation.frames_per_s = 2;
    animation.node_of_instance = {kNoNode, kNoNode};
    animation.vertex_frames.resize(2);
    for (int f = 0; f < 3; ++f) {
        for (std::size_t m = 0; m < 2; ++m) {
            if (m == 1 && f == 2) continue;
            VertexFrames& frames = animation.vertex_frames[m];
            ++frames.frame_count;
            for (const glm::vec3& p : scene.meshes[m].positions) {
                frames.positions.push_back(p + glm::vec3(0, 0, 8 * f));
                frames.normals.push_back(f == 1 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1));
            }
        }
    }
    scene.animation = std::make_shared<const Animation>(animation);
    return scene;
}

TEST(AnimationFrames, AtTheirTimesTheyAreThemselves) {
    Scene scene = framed_triangles();
    ASSERT_EQ(scene.animation->frame_count(), 3U);
    for (std::size_t f = 0; f < 3; ++f) {
        pose_scene(scene, scene.animation->frame_time_s(f));
        EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(1, 0, 8 * static_cast<float>(f)));
        EXPECT_EQ(scene.meshes[1].positions[1].z, f == 0 ? 0 : 8) << "the shorter one stays";
        EXPECT_EQ(scene.meshes[0].normals[1], f == 1 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1));
    }
}

TEST(AnimationFrames, BetweenThemTheyAreBlended) {
    Scene scene = framed_triangles();
    pose_scene(scene, 0.25);
    EXPECT_EQ(scene.meshes[0].positions[2], glm::vec3(0, 1, 4));
    EXPECT_NEAR(scene.meshes[0].normals[0].x, kHalfRoot, 1e-6);
    EXPECT_NEAR(scene.meshes[0].normals[0].z, kHalfRoot, 1e-6);
    pose_scene(scene, 0.75);
    EXPECT_EQ(scene.meshes[0].positions[2].z, 12);
    EXPECT_EQ(scene.meshes[1].positions[2].z, 8);
}

TEST(AnimationFrames, TheLastStaysHoweverLongItTakes) {
    Scene scene = framed_triangles();
    Animation animation = *scene.animation;
    animation.duration_s = 1e25;  // of frames more than a whole number holds
    scene.animation = std::make_shared<const Animation>(animation);
    check_animation(scene, animation);
    pose_scene(scene, 1e25);
    EXPECT_EQ(scene.meshes[0].positions[2].z, 16);
    EXPECT_EQ(scene.meshes[0].normals[0], glm::vec3(0, 0, 1));
}

/// Two bones at x = 0 and x = 2, the second turning by 90 degrees about z; a vertex on each and one
/// between, bound as they stand.
Scene bent_strip() {
    Scene scene = small_triangles(1);
    Mesh& mesh = scene.meshes[0];
    mesh.positions = {{0, 0, 0}, {4, 0, 0}, {3, 0, 0}};
    mesh.normals = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
    Animation animation;
    animation.duration_s = 1;
    AnimatedNode shoulder;
    AnimatedNode elbow;
    elbow.parent = 0;
    elbow.parent_from_node[3] = {2, 0, 0, 1};
    elbow.translations = {{0, {2, 0, 0}}};
    elbow.rotations = {{0, {1, 0, 0, 0}}, {1, {kHalfRoot, 0, 0, kHalfRoot}}};
    elbow.scales = {{0, {1, 1, 1}}};
    animation.nodes = {shoulder, elbow};
    animation.node_of_instance = {kNoNode};
    Skin skin{0, mesh.positions, mesh.normals, {{0, glm::dmat4(1)}, {1, glm::dmat4(1)}}, {}, {}};
    skin.bones[1].node_from_mesh[3] = {-2, 0, 0, 1};
    set_weights({{{0, 1}}, {{1, 1}}, {{0, 1}, {1, 3}}}, skin);
    animation.skins = {skin};
    scene.animation = std::make_shared<const Animation>(animation);
    return scene;
}

TEST(AnimationSkin, VerticesFollowTheirBonesByWeight) {
    Scene scene = bent_strip();
    check_animation(scene, *scene.animation);
    pose_scene(scene, 0);
    EXPECT_EQ(scene.meshes[0].positions, bent_strip().meshes[0].positions);
    pose_scene(scene, 1);
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.positions[0], glm::vec3(0, 0, 0));
    expect_near(mesh.positions[1], {2, 2, 0}, 1e-6);
    // A quarter of (3,0,0), three of (2,1,0).
    expect_near(mesh.positions[2], {2.25, 0.75, 0}, 1e-6);
    expect_near(mesh.normals[1], {-1, 0, 0}, 1e-6);
    expect_near(mesh.normals[0], {0, 1, 0}, 1e-6);
}

/// What check_animation says of `scene` after `spoil` had its way with the animation.
template <class Spoil>
std::string complaint(Scene scene, Spoil spoil) {
    Animation animation = *scene.animation;
    spoil(animation);
    try {
        check_animation(scene, animation);
    } catch (const core::Error& error) {
        EXPECT_EQ(error.where(), scene.name + ", animation");
        return error.what_happened();
    }
    return "";
}

TEST(AnimationCheck, SoundOnesPass) {
    for (const Scene& scene : {moving_cubes(), framed_triangles(), bent_strip()})
        EXPECT_EQ(complaint(scene, [](Animation&) {}), "");
}

TEST(AnimationCheck, RefusesKeysThatAreNone) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const Scene scene = moving_cubes();
    const auto of_node = [&](auto spoil) {
        return complaint(scene, [&](Animation& a) { spoil(a.nodes[0]); });
    };
    EXPECT_EQ(of_node([](AnimatedNode& n) { n.translations[1].value.x = kNan; }),
              "node 0, key 1 is not finite or no rotation");
    EXPECT_EQ(of_node([](AnimatedNode& n) { n.rotations[0].time_s = kNan; }),
              "node 0, key 0 is not finite or no rotation");
    EXPECT_EQ(of_node([](AnimatedNode& n) { n.rotations[1].value *= 2; }),
              "node 0, key 1 is not finite or no rotation");
    EXPECT_EQ(of_node([](AnimatedNode& n) { n.scales[1].time_s = 0.5; }),
              "node 0, key 1 goes back in time");
    EXPECT_EQ(of_node([](AnimatedNode& n) { n.scales.clear(); }),
              "node 0 has keys of one kind only");
    EXPECT_EQ(of_node([](AnimatedNode& n) { n.parent = 0; }), "node 0 has the parent 0");
    EXPECT_EQ(of_node([](AnimatedNode& n) { n.parent_from_node[2][1] = kNan; }),
              "node 0 has a transform that is not affine");
    EXPECT_THAT(of_node([](AnimatedNode& n) { n.scales[1].value.y = 1e200; }),
                testing::StartsWith("it may reach"));
    EXPECT_EQ(complaint(scene, [](Animation& a) { a.duration_s = kNan; }), "it lasts nan s");
}

/// The cubes, and a camera in the mover's node.
Scene filmed_cubes() {
    Scene scene = moving_cubes();
    scene.cameras = {look_at({0, 0, 9}, {0, 0, 0}, {0, 1, 0}, 0.7)};
    scene.cameras[0].near = 3;
    Animation animation = *scene.animation;
    animation.node_of_camera = {0};
    scene.animation = std::make_shared<const Animation>(animation);
    return scene;
}

TEST(AnimationCamera, GoesWithItsNode) {
    Scene scene = filmed_cubes();
    check_animation(scene, *scene.animation);
    pose_scene(scene, 3);
    const Camera& camera = scene.cameras[0];
    expect_near(camera.eye_world, {5, 2, 3});
    // The node has turned by 90 degrees about z: its up is -x.
    expect_near(camera.view_from_world * glm::dvec3(-1, 0, 0), {0, 1, 0});
    expect_near(camera.view_from_world * glm::dvec3(0, 0, -1), {0, 0, -1});
    EXPECT_EQ(camera.near, 3);
    EXPECT_EQ(camera.fov_y_rad, 0.7);
}

TEST(AnimationCamera, OneInANodeSqueezedFlatLooksAlongMinusZ) {
    for (const double x : {1.0, 3e20}) {  // where a step of 1 is lost in rounding, too
        Scene scene = filmed_cubes();
        Animation animation = *scene.animation;
        animation.nodes[0].translations = {{0, {x, 2, 3}}};
        animation.nodes[0].rotations = {{0, {1, 0, 0, 0}}};
        animation.nodes[0].scales = {{0, {0, 0, 0}}};
        scene.animation = std::make_shared<const Animation>(animation);
        check_animation(scene, animation);
        pose_scene(scene, 1);
        EXPECT_EQ(scene.cameras[0].eye_world, glm::dvec3(x, 2, 3));
        const glm::dmat3& view_from_world = scene.cameras[0].view_from_world;
        EXPECT_EQ(view_from_world * glm::dvec3(0, 0, -1), glm::dvec3(0, 0, -1));
    }
}

TEST(AnimationCamera, OnesWithoutANodeStay) {
    Scene scene = filmed_cubes();
    Animation animation = *scene.animation;
    animation.node_of_camera = {kNoNode};
    scene.animation = std::make_shared<const Animation>(animation);
    pose_scene(scene, 3);
    EXPECT_EQ(scene.cameras[0].eye_world, glm::dvec3(0, 0, 9));
}

/// The cubes, and two lights: one at (1, 0, 0) in the mover's node, one that stands.
Scene lit_cubes() {
    Scene scene = moving_cubes();
    scene.lights = {{.p_world = {2, 2, 3}, .color = {1, 0, 0}, .range = 5},
                    {.p_world = {0, 9, 0}, .color = {1, 0, 0}, .range = 0}};
    Animation animation = *scene.animation;
    animation.lights = {{0, {1, 0, 0}}, {}};
    scene.animation = std::make_shared<const Animation>(animation);
    return scene;
}

TEST(AnimationLight, GoesWithItsNode) {
    Scene scene = lit_cubes();
    pose_scene(scene, 3);
    expect_near(scene.lights[0].p_world, {5, 3, 3});
    EXPECT_EQ(scene.lights[0].color, glm::vec3(1, 0, 0));
    EXPECT_EQ(scene.lights[0].range, 5);
    EXPECT_EQ(scene.lights[1].p_world, glm::dvec3(0, 9, 0));
}

TEST(AnimationCheck, RefusesLightsThatDoNotFit) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const Scene scene = lit_cubes();
    EXPECT_EQ(complaint(scene, [](Animation&) {}), "");
    EXPECT_EQ(complaint(scene, [](Animation& a) { a.lights.resize(3); }), "it moves 3 lights of 2");
    EXPECT_EQ(complaint(scene, [](Animation& a) { a.lights[0].node = 2; }),
              "a light hangs on node 2");
    EXPECT_EQ(complaint(scene, [](Animation& a) { a.lights[0].p_node.x = kNan; }),
              "a light has a place that is not finite");
    EXPECT_THAT(complaint(scene, [](Animation& a) { a.lights[0].p_node.x = 1e40; }),
                testing::HasSubstr("it may reach"));
}

TEST(BoundsOfPoses, HoldTheSceneInAllOfThem) {
    const Scene scene = moving_cubes();
    const Sphere all = bounds_of_poses(scene, std::array{1.0, 2.0, 3.0});
    for (const double time_s : {1.0, 2.0, 3.0}) {
        Scene posed = scene;
        pose_scene(posed, time_s);
        for (const Instance& instance : posed.instances) {
            for (const glm::vec3& p : posed.meshes[instance.mesh].positions)
                EXPECT_LE(glm::length(to_world(instance, p) - all.center_world),
                          all.radius * (1 + 1e-12));
        }
    }
    EXPECT_EQ(bounds_of_poses(scene, {}).radius, bounding_sphere(scene).radius);
}

TEST(AnimationCheck, RefusesCamerasThatDoNotFit) {
    const Scene scene = filmed_cubes();
    EXPECT_EQ(complaint(scene, [](Animation& a) { a.node_of_camera.resize(2); }),
              "it moves 2 cameras of 1");
    EXPECT_EQ(complaint(scene, [](Animation& a) { a.node_of_camera = {2}; }),
              "a camera hangs on node 2");
}

TEST(AnimationCheck, RefusesWhatDoesNotFitTheScene) {
    EXPECT_EQ(complaint(moving_cubes(), [](Animation& a) { a.node_of_instance[1] = 2; }),
              "an instance hangs on node 2");
    EXPECT_EQ(complaint(moving_cubes(), [](Animation& a) { a.node_of_instance.pop_back(); }),
              "it moves 1 instances of 2");
    const Scene framed = framed_triangles();
    EXPECT_EQ(complaint(framed, [](Animation& a) { a.vertex_frames.pop_back(); }),
              "1 lists of frames for 2 meshes");
    EXPECT_EQ(complaint(framed, [](Animation& a) { a.vertex_frames[0].frame_count = 4; }),
              "the frames of mesh 0: 9 positions for 4 frames of 3 vertices");
    EXPECT_EQ(complaint(framed, [](Animation& a) { a.vertex_frames[0].frame_count = ~0ULL; }),
              "the frames of mesh 0: 9 positions for 18446744073709551615 frames of 3 vertices");
    EXPECT_EQ(complaint(framed, [](Animation& a) { a.vertex_frames[1].normals.pop_back(); }),
              "the frames of mesh 1: 5 normals");
    EXPECT_EQ(complaint(framed, [](Animation& a) { a.frames_per_s = 0; }), "0 frames a second");
    const Scene bent = bent_strip();
    EXPECT_EQ(complaint(bent, [](Animation& a) { a.skins[0].mesh = 1; }), "skin 0 is of mesh 1");
    EXPECT_EQ(complaint(bent, [](Animation& a) { a.skins[0].bones[1].node = 2; }),
              "skin 0 has a bone at node 2");
    // As the product of a node and a bone, the last number scales how far the node was moved.
    EXPECT_EQ(
        complaint(bent, [](Animation& a) { a.skins[0].bones[0].node_from_mesh[3].w = 1e231; }),
        "skin 0 has a bone whose transform is not affine");
    EXPECT_EQ(complaint(bent, [](Animation& a) { a.nodes[1].parent_from_node[1].w = -1; }),
              "node 1 has a transform that is not affine");
    EXPECT_EQ(complaint(bent, [](Animation& a) { a.skins[0].weights[2].bone = 2; }),
              "skin 0 follows bone 2");
    EXPECT_EQ(complaint(bent, [](Animation& a) { a.skins[0].weights[2].weight = -1; }),
              "skin 0 has the weight -1");
    EXPECT_EQ(complaint(bent, [](Animation& a) { a.skins[0].first_weight.back() = 9; }),
              "skin 0 does not say which weights are whose");
}

}  // namespace
}  // namespace ink::scene
