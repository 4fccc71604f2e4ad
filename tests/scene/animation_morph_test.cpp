// Shares of targets, keys that are no straight way, and how far an animation may reach.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "core/error.h"
#include "scene/animation.h"
#include "scene/animation/animation_reach.h"
#include "tests/scene/small_meshes.h"

namespace ink::scene {
namespace {

void expect_near(const glm::dvec3& found, const glm::dvec3& expected, double tolerance = 1e-6) {
    EXPECT_LT(glm::length(found - expected), tolerance)
        << found.x << ' ' << found.y << ' ' << found.z;
}

AnimatedNode mover(const Course<glm::dvec3>& course) {
    AnimatedNode node;
    node.translations = {{1, {0, 0, 0}}, {3, {4, 8, 0}}};
    node.rotations = {{0, {1, 0, 0, 0}}};
    node.scales = {{0, {1, 1, 1}}};
    node.translation_course = course;
    return node;
}

TEST(AnimationCourse, StepsKeepTheEarlierKey) {
    const AnimatedNode node = mover({.interpolation = Interpolation::step, .tangents = {}});
    EXPECT_EQ(glm::dvec3(node.at(0)[3]), glm::dvec3(0, 0, 0));
    EXPECT_EQ(glm::dvec3(node.at(2.999)[3]), glm::dvec3(0, 0, 0));
    EXPECT_EQ(glm::dvec3(node.at(3)[3]), glm::dvec3(4, 8, 0));
}

TEST(AnimationCourse, CubicOnesLeaveAndReachKeysAlongTheirTangents) {
    const AnimatedNode node = mover(
        {.interpolation = Interpolation::cubic, .tangents = {{{}, {3, 0, 0}}, {{0, -5, 0}, {}}}});
    // Hermite's basis at a half: 1/2, 1/8, 1/2, -1/8; tangents are per second, of two.
    expect_near(node.at(2)[3], {4 * 0.5 + 2 * 3 * 0.125, 8 * 0.5 + 2 * 5 * 0.125, 0}, 1e-12);
    EXPECT_EQ(glm::dvec3(node.at(1)[3]), glm::dvec3(0, 0, 0));
    EXPECT_EQ(glm::dvec3(node.at(3)[3]), glm::dvec3(4, 8, 0));
    constexpr double kStep_s = 1e-6;
    expect_near(glm::dvec3(node.at(1 + kStep_s)[3]) / kStep_s, {3, 0, 0}, 1e-4);
    expect_near(
        (glm::dvec3(4, 8, 0) - glm::dvec3(node.at(3 - kStep_s)[3])) / kStep_s, {0, -5, 0}, 1e-4);
}

/// A triangle that two targets lift and widen: the first at rest by half, the second by keys.
Scene shaped_triangle() {
    Scene scene = small_triangles(1);
    const Mesh& mesh = scene.meshes[0];
    Animation animation;
    animation.duration_s = 2;
    animation.node_of_instance = {kNoNode};
    Morph morph;
    morph.positions = mesh.positions;
    morph.normals = mesh.normals;
    morph.targets.resize(2);
    morph.targets[0].positions = {{0, 0, 2}, {0, 0, 2}, {0, 0, 2}};
    morph.targets[0].weight = 0.5;
    morph.targets[1].positions = {{0, 0, 0}, {3, 0, 0}, {0, 0, 0}};
    morph.targets[1].normals = {{0, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    morph.targets[1].weights = {{0, 0}, {2, 2}};
    animation.morphs = {morph};
    scene.animation = std::make_shared<const Animation>(animation);
    return scene;
}

TEST(AnimationMorph, VerticesAreTheBaseAndSharesOfTheTargets) {
    Scene scene = shaped_triangle();
    check_animation(scene, *scene.animation);
    rest_scene(scene);
    EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(1, 0, 1));
    pose_scene(scene, 1);
    EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(4, 0, 1));
    EXPECT_EQ(scene.meshes[0].positions[2], glm::vec3(0, 1, 1));
    expect_near(scene.meshes[0].normals[1], glm::dvec3(0, 1, 1) / std::sqrt(2));
    EXPECT_EQ(scene.meshes[0].normals[2], glm::vec3(0, 0, 1)) << "none is left: the base's";
    pose_scene(scene, 2);
    EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(7, 0, 1));
    pose_scene(scene, 0);
    EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(1, 0, 1)) << "nothing adds up";
}

TEST(AnimationMorph, BonesTakeTheShape) {
    Scene scene = shaped_triangle();
    Animation animation = *scene.animation;
    AnimatedNode bone;
    bone.parent_from_node[3] = {0, 0, 10, 1};
    animation.nodes = {bone};
    Skin skin;
    skin.positions = scene.meshes[0].positions;
    skin.normals = scene.meshes[0].normals;
    skin.bones = {{0, glm::dmat4(1)}};
    set_weights({{{0, 1}}, {{0, 1}}, {{0, 1}}}, skin);
    animation.skins = {skin};
    scene.animation = std::make_shared<const Animation>(animation);
    check_animation(scene, animation);
    pose_scene(scene, 1);
    EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(4, 0, 11));
}

/// What check_animation says after `spoil` had its way with the animation of shaped_triangle().
template <class Spoil>
std::string complaint(Spoil spoil) {
    const Scene scene = shaped_triangle();
    Animation animation = *scene.animation;
    spoil(animation.morphs[0], animation);
    try {
        check_animation(scene, animation);
    } catch (const core::Error& error) {
        return error.what_happened();
    }
    return "";
}

TEST(AnimationMorph, RefusesWhatDoesNotFit) {
    using A = Animation;
    EXPECT_EQ(complaint([](Morph& m, A&) { m.mesh = 1; }), "morph 0 is of mesh 1");
    EXPECT_EQ(complaint([](Morph& m, A& a) { a.morphs.push_back(m); }), "morph 1 is of mesh 0");
    EXPECT_EQ(complaint([](Morph& m, A&) { m.positions.pop_back(); }),
              "morph 0 has 2 positions and 3 normals");
    EXPECT_EQ(complaint([](Morph& m, A&) { m.targets[1].positions.pop_back(); }),
              "morph 0 has a target of 2 positions and 3 normals");
    EXPECT_EQ(complaint([](Morph& m, A&) { m.targets[0].weight = NAN; }),
              "morph 0 has a share that is not finite");
    EXPECT_EQ(complaint([](Morph& m, A&) { m.targets[1].weights[1].time_s = -1; }),
              "morph 0, key 1 goes back in time");
    EXPECT_EQ(
        complaint([](Morph& m, A&) { m.targets[1].course.interpolation = Interpolation::cubic; }),
        "morph 0 has 0 tangents");
    EXPECT_EQ(complaint([](Morph& m, A&) {
                  m.targets[1].course.interpolation = static_cast<Interpolation>(7);
              }),
              "morph 0 has keys that are blended in no known way");
    EXPECT_EQ(complaint([](Morph& m, A&) { m.targets[1].weights[1].value = 1e30; }),
              "it may reach 3e+30");
}

glm::dquat random_turn(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(
        glm::dquat(normal(random), normal(random), normal(random), normal(random)));
}

TEST(AnimationReach, TurnsGrowNothingHoweverDeep) {
    std::mt19937_64 random(7);
    Animation animation;
    for (std::uint32_t n = 0; n < 500; ++n) {
        AnimatedNode node;
        node.parent = n == 0 ? kNoNode : n - 1;
        node.parent_from_node =
            glm::translate(glm::dmat4(1), {0, 0.5, 0}) * glm::mat4_cast(random_turn(random));
        if (n % 2 == 0) {
            node.translations = {{0, {0, 0.5, 0}}};
            node.rotations = {{0, random_turn(random)}, {1, random_turn(random)}};
            node.scales = {{0, {1, 1, 1}}};
        }
        animation.nodes.push_back(node);
    }
    const Reach last = reaches(animation).back();
    EXPECT_NEAR(last.grows, 1, 1e-9);
    EXPECT_LE(last.moved, 250 + 1e-9);
}

TEST(AnimationReach, WhatOneScalesAnotherMayTakeBack) {
    Animation animation;
    for (std::uint32_t n = 0; n < 500; ++n) {
        AnimatedNode node;
        node.parent = n == 0 ? kNoNode : n - 1;
        // A shear, and the one that undoes it.
        node.parent_from_node[1].x = n % 2 == 0 ? 3 : -3;
        animation.nodes.push_back(node);
    }
    EXPECT_NEAR(reaches(animation).back().grows, 1, 1e-9);
}

/// A tree of nodes that turn, scale and shear, some of them by keys of every course.
Animation random_tree(std::mt19937_64& random) {
    std::uniform_real_distribution<double> number(-2, 2);
    const auto vector = [&] { return glm::dvec3(number(random), number(random), number(random)); };
    Animation animation;
    animation.duration_s = 2;
    for (std::uint32_t n = 0; n < 8; ++n) {
        AnimatedNode node;
        node.parent = n == 0 ? kNoNode : static_cast<std::uint32_t>(random() % n);
        for (int column = 0; column < 4; ++column)
            node.parent_from_node[column] = glm::dvec4(vector(), column == 3 ? 1 : 0);
        for (int key = 0; key < 3 && n % 3 != 0; ++key) {
            node.translations.push_back({key * 1.0, vector()});
            node.rotations.push_back({key * 1.0, random_turn(random)});
            node.scales.push_back({key * 1.0, vector()});
            node.translation_course.tangents.push_back({vector(), vector()});
            node.scale_course.tangents.push_back({vector(), vector()});
        }
        if (node.has_keys()) {
            node.translation_course.interpolation = Interpolation::cubic;
            node.scale_course.interpolation = Interpolation::cubic;
        }
        animation.nodes.push_back(node);
    }
    return animation;
}

TEST(AnimationReach, NothingGoesFarther) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 200; ++trial) {
        const Animation animation = random_tree(random);
        const std::vector<Reach> reach = reaches(animation);
        for (int step = -1; step <= 40; ++step) {
            const auto world =
                world_from_nodes(animation, step < 0 ? std::optional<double>() : step * 0.05);
            for (std::size_t n = 0; n < world.size(); ++n) {
                const glm::dvec3 p =
                    glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
                const double distance = glm::length(glm::dvec3(world[n] * glm::dvec4(p, 1)));
                ASSERT_LE(distance, reach[n].of(1) * (1 + 1e-12)) << trial << ' ' << n;
            }
        }
    }
}

}  // namespace
}  // namespace ink::scene
