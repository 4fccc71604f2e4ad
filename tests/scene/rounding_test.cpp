#include "scene/precision/rounding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/glm.hpp>
#include <numbers>
#include <random>

#include "tests/scene/small_meshes.h"

namespace ink::scene {
namespace {

Scene scene_of(const std::vector<glm::vec3>& positions, const std::vector<Triangle>& triangles) {
    return scene_of(Mesh{"part", positions, {}, triangles, {}});
}

/// Any rotation, each as likely as another.
glm::dmat3 random_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const glm::dvec3 x = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    const glm::dvec3 other(normal(random), normal(random), normal(random));
    const glm::dvec3 z = glm::normalize(glm::cross(x, other));
    return {x, glm::cross(z, x), z};
}

/// Two faces that share the edge from the origin along x and bend by an angle there, turned, each
/// coordinate rounded to float as a file would have it.
Topology bent_by(double angle_rad, const glm::dmat3& rotation) {
    const std::array<glm::dvec3, 4> p = {glm::dvec3(0, 0, 0),
                                         {3, 0, 0},
                                         {1, -2, 0},
                                         {2, 2 * std::cos(angle_rad), 2 * std::sin(angle_rad)}};
    std::vector<glm::vec3> turned;
    for (const glm::dvec3& q : p)
        turned.push_back(glm::vec3(rotation * (q + glm::dvec3(5, 7, -4))));
    return weld(scene_of(turned, {{0, 2, 1}, {0, 1, 3}}));
}

bool creases(const Topology& topology, double crease_rad) {
    for (const Edge& edge : topology.edges)
        if (edge.face_count == 2) return is_crease(topology, edge, 0, 1, crease_rad);
    ADD_FAILURE() << "no edge of two faces";
    return false;
}

TEST(Rounding, IsHalfAUnitOfTheLargestCoordinateAlongEachAxis) {
    Scene scene = scene_of({{1, 0.25F, 0}, {0, 4, 1}, {0, 0, -100}}, {{0, 1, 2}});
    const double half_ulp = std::ldexp(1.0, -24);
    Topology topology = weld(scene);
    EXPECT_DOUBLE_EQ(topology.rounding_world[0], 3 * half_ulp);
    EXPECT_DOUBLE_EQ(topology.rounding_world[1], 3 * 4 * half_ulp);
    EXPECT_DOUBLE_EQ(topology.rounding_world[2], 3 * 64 * half_ulp);
    scene.instances[0].world_from_object = glm::scale(glm::dmat4(1), glm::dvec3(2, 3, 4));
    topology = weld(scene);
    EXPECT_DOUBLE_EQ(topology.rounding_world[0], 9 * half_ulp);
}

TEST(Rounding, LeavesASignOpenUpToTheHeightThatItCanMove) {
    const RoundedPoint a{{0, 0, 0}, 1e-3}, b{{1, 0, 0}, 1e-3}, c{{0, 1, 0}, 1e-3};
    // Over the middle of the triangle its own rounding and the point's add up.
    for (const double sign : {1.0, -1.0}) {
        EXPECT_EQ(sure_orient3d(a, b, c, {{0.3, 0.3, sign * 1.9e-3}, 1e-3}), 0);
        EXPECT_EQ(sure_orient3d(a, b, c, {{0.3, 0.3, sign * 2.1e-3}, 1e-3}), sign > 0 ? -1 : 1);
    }
    // A plane that is followed farther is more open: at x = 10 by 1 + 9 + 10 times the rounding.
    EXPECT_EQ(sure_orient3d(a, b, c, {{10, 0, 19e-3}, 0}), 0);
    EXPECT_EQ(sure_orient3d(a, b, c, {{10, 0, 21e-3}, 0}), -1);
}

TEST(IsCrease, HoldsForTheVeryAngleInEveryPose) {
    std::mt19937 random(3);
    for (const double angle_deg : {30.0, 40.0, 45.0, 60.0, 90.0}) {
        const double angle_rad = angle_deg * std::numbers::pi / 180;
        for (int i = 0; i < 200; ++i) {
            const glm::dmat3 rotation = random_rotation(random);
            EXPECT_TRUE(creases(bent_by(angle_rad, rotation), angle_rad)) << angle_deg;
            EXPECT_FALSE(creases(bent_by(angle_rad - 1e-4, rotation), angle_rad)) << angle_deg;
        }
    }
}

TEST(IsCrease, ANeedleIsJudgedByTheBendItHas) {
    // The second face is 1e-6 high: rounding turns it by tens of degrees.
    const auto needle = [](float z) {
        return weld(
            scene_of({{0, 0, 0}, {3, 0, 0}, {1, -2, 0}, {2, 1e-6F, z}}, {{0, 2, 1}, {0, 1, 3}}));
    };
    constexpr double k40 = 40 * std::numbers::pi / 180;
    EXPECT_FALSE(creases(needle(0.7e-6F), k40)) << "35 degrees";
    EXPECT_TRUE(creases(needle(1e-6F), k40)) << "45 degrees";
}

TEST(Rounding, OfAViewIsThatOfItsNearestVertex) {
    const Scene scene = scene_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    Topology topology = weld(scene);
    topology.rounding_world = {0, 0, 0.001};
    View view{look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, std::numbers::pi / 2), 200, 200};
    view.camera.near = 0.1;
    // 200 px are 8 units high where the triangle stands.
    EXPECT_NEAR(most_rounding_px(topology, view), 0.001 * 200 / 8, 1e-9);
    view.camera = look_at({0, 0, 4}, {0, 0, 8}, {0, 1, 0}, std::numbers::pi / 2);
    EXPECT_EQ(most_rounding_px(topology, view), 0) << "it is behind";
}

TEST(Rounding, OfTheFileCountsWhereItIsMore) {
    Scene scene = scene_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    const double of_floats = weld(scene).rounding_world[1];
    scene.meshes[0].rounding = 0.25;
    EXPECT_LT(of_floats, 1e-6);
    for (const double rounding : weld(scene).rounding_world)
        EXPECT_GE(rounding, 0.25);
}

}  // namespace
}  // namespace ink::scene
