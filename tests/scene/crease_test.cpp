#include "scene/crease.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "scene/materials.h"
#include "tests/scene/small_meshes.h"

namespace ink::scene {
namespace {

using testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180;
constexpr CreaseRule kByAngle{40 * kDegree, CreaseSource::angle};
constexpr CreaseRule kByFile{40 * kDegree, CreaseSource::file};

/// A unit square in two triangles, and one that stands on its side from (1, 0, 0) to (1, 1, 0).
Mesh square_and_wall() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0.5F, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 4}};
    return mesh;
}

/// Whether the edge between two places creases; it has to have two faces.
bool creases(const Topology& topology, glm::dvec3 p, glm::dvec3 q, const CreaseRule& rule) {
    for (const Edge& edge : topology.edges) {
        const glm::dvec3 &a = topology.p_world[edge.a], &b = topology.p_world[edge.b];
        if (!(a == p && b == q) && !(a == q && b == p)) continue;
        const auto faces = topology.faces_of(edge);
        EXPECT_GE(faces.size(), 2U);
        return is_crease(topology, edge, faces[0], faces[1], rule);
    }
    ADD_FAILURE() << "there is no such edge";
    return false;
}

constexpr glm::dvec3 kLow{0, 0, 0}, kCorner{1, 0, 0}, kHigh{1, 1, 0};

TEST(Crease, OfTheFileAreTheMarkedSidesWhateverTheyBend) {
    Scene scene = scene_of(square_and_wall());
    scene.meshes[0].marked_sides = {0b100, 0, 0};  // the diagonal
    const Topology topology = weld(scene);
    EXPECT_TRUE(creases(topology, kLow, kHigh, kByFile));
    EXPECT_FALSE(creases(topology, kCorner, kHigh, kByFile));
    EXPECT_FALSE(creases(topology, kLow, kHigh, kByAngle));
    EXPECT_TRUE(creases(topology, kCorner, kHigh, kByAngle));
}

TEST(Crease, EitherTriangleMayMarkASide) {
    for (const std::uint8_t first : std::array<std::uint8_t, 2>{0, 0b010}) {
        Scene scene = scene_of(square_and_wall());
        scene.meshes[0].marked_sides = {first, 0, static_cast<std::uint8_t>(first == 0 ? 1 : 0)};
        EXPECT_TRUE(creases(weld(scene), kCorner, kHigh, kByFile));
    }
}

TEST(Crease, MarksStayWithTheirSidesInAMirror) {
    for (const std::uint8_t sides : std::array<std::uint8_t, 3>{0b001, 0b010, 0b100}) {
        Scene scene = scene_of(square_and_wall());
        scene.meshes[0].marked_sides = {sides, 0, 0};
        const Topology straight = weld(scene);
        scene.instances[0].world_from_object = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
        const Topology mirrored = weld(scene);
        const glm::dvec3 turn{-1, 1, 1};
        EXPECT_EQ(creases(mirrored, kLow * turn, kHigh * turn, kByFile),
                  creases(straight, kLow, kHigh, kByFile));
        EXPECT_EQ(creases(mirrored, kCorner * turn, kHigh * turn, kByFile),
                  creases(straight, kCorner, kHigh, kByFile));
    }
}

TEST(Crease, BetweenObjectsTheAngleDecides) {
    Mesh wall = square_and_wall(), square = wall;
    square.triangles.pop_back();
    square.marked_sides = {0b100, 0};
    wall.triangles = {wall.triangles.back()};
    Scene scene = scene_of(square);
    scene.meshes.push_back(wall);
    scene.instances.push_back({1, glm::dmat4(1), "wall"});
    EXPECT_TRUE(creases(weld(scene), kCorner, kHigh, kByFile));
    EXPECT_TRUE(creases(weld(scene), kLow, kHigh, kByFile));
}

TEST(Crease, WithAThirdFaceOfTheObjectTheAngleDecides) {
    Mesh mesh = square_and_wall();
    mesh.positions.emplace_back(2, 0.5F, 0);  // the square goes on beside the wall
    mesh.triangles.push_back({1, 5, 2});
    mesh.marked_sides = {0b010, 0, 0b001, 0b100};
    const Topology topology = weld(scene_of(mesh));
    for (const Edge& edge : topology.edges) {
        if (edge.face_count != 3) continue;
        EXPECT_FALSE(is_crease(topology, edge, 0, 3, kByFile));
        EXPECT_TRUE(is_crease(topology, edge, 0, 2, kByFile));
    }
}

TEST(Crease, MarksGoWithTheirTrianglesIntoObjectsOfOneMaterial) {
    Scene scene = scene_of(square_and_wall());
    scene.meshes[0].materials = {1, 1, 2};
    scene.meshes[0].marked_sides = {0b100, 0, 0b011};
    split_materials(scene);
    EXPECT_EQ(scene.meshes[0].marked_sides, (std::vector<std::uint8_t>{0b100, 0}));
    EXPECT_EQ(scene.meshes[1].marked_sides, (std::vector<std::uint8_t>{0b011}));
}

TEST(Crease, MarksAreOfEachTriangleAndPartOfTheScene) {
    Scene scene = scene_of(square_and_wall());
    const std::uint64_t without = scene_hash(scene);
    scene.meshes[0].marked_sides = {0, 0, 1};
    EXPECT_NO_THROW(check_scene(scene));
    EXPECT_NE(scene_hash(scene), without);
    scene.meshes[0].marked_sides.pop_back();
    EXPECT_THROW(check_scene(scene), core::Error);
}

TEST(Crease, AFileWithoutMarksHasNone) {
    Scene scene = scene_of(square_and_wall());
    EXPECT_NO_THROW(check_creases(scene, CreaseSource::angle));
    try {
        check_creases(scene, CreaseSource::file);
        ADD_FAILURE() << "nothing was thrown";
    } catch (const core::Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("it marks no edges"));
    }
    scene.meshes[0].marked_sides = {0, 0, 0};
    EXPECT_NO_THROW(check_creases(scene, CreaseSource::file));
}

/// A closed drum of `sides` sides of height 2.
Scene drum(int sides) {
    Mesh mesh;
    for (int i = 0; i < sides; ++i) {
        const double angle_rad = 2 * std::numbers::pi * i / sides;
        for (const float y : {-1.0F, 1.0F})
            mesh.positions.emplace_back(std::cos(angle_rad), y, std::sin(angle_rad));
    }
    const auto low = [&](int i) { return static_cast<std::uint32_t>(2 * (i % sides)); };
    for (int i = 0; i < sides; ++i) {
        mesh.triangles.push_back({low(i), low(i) + 1, low(i + 1) + 1});
        mesh.triangles.push_back({low(i), low(i + 1) + 1, low(i + 1)});
        if (i < 2) continue;
        mesh.triangles.push_back({low(0), low(i - 1), low(i)});
        mesh.triangles.push_back({low(0) + 1, low(i) + 1, low(i - 1) + 1});
    }
    return scene_of(mesh);
}

TEST(CreaseProposal, LiesBetweenTheSidesOfADrumAndItsLids) {
    // The sides bend by 360 / n degrees, the lids by 90: the gap ends at 60.
    const auto expect_gap = [](int sides, double from_deg, double angle_deg) {
        const CreaseProposal proposal = propose_crease(weld(drum(sides)));
        EXPECT_NEAR(proposal.from_rad, from_deg * kDegree, 1e-12) << sides;
        EXPECT_NEAR(proposal.to_rad, 60 * kDegree, 1e-12) << sides;
        EXPECT_NEAR(proposal.angle_rad, angle_deg * kDegree, 1e-12) << sides;
    };
    expect_gap(32, 12, 27);  // 11.25 degrees; sqrt(12 60) is 26.8
    expect_gap(22, 17, 32);
    expect_gap(14, 26, 39);
}

TEST(CreaseProposal, WithoutAnyBendIsTheUsualAngle) {
    Mesh flat = square_and_wall();
    flat.triangles.pop_back();
    EXPECT_NEAR(propose_crease(weld(scene_of(flat))).angle_rad, 40 * kDegree, 1e-12);
    EXPECT_NEAR(propose_crease(Topology{}).angle_rad, 40 * kDegree, 1e-12);
}

}  // namespace
}  // namespace ink::scene
