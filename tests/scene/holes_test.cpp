#include "scene/holes/holes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "catalogue/shapes.h"
#include "scene/clusters.h"
#include "scene/predicates.h"
#include "tests/scene/small_meshes.h"

namespace ink::scene {
namespace {

/// A ball without its faces whose middle lies within `radius` of one of the points.
Mesh ball_without(const std::vector<glm::dvec3>& points, double radius, int levels = 4) {
    return without(catalogue::make_icosphere(1, levels), points, radius);
}

/// Moves what lies within 0.3 of a ball's point opposite to its hole at (0, 1, 0) towards the hole,
/// to a tip at height `tip`.
Mesh with_spike(Mesh mesh, double tip) {
    for (glm::vec3& p : mesh.positions) {
        const double away = std::hypot(p.x, p.z);
        if (p.y < 0 && away < 0.3) p.y = static_cast<float>(p.y + (tip + 1) * (1 - away / 0.3));
    }
    return mesh;
}

Clusters clusters_of(const Mesh& mesh) {
    return make_clusters(flatten(scene_of(mesh)));
}

/// Whether the mesh, one solid with `holes` holes, is watertight once they are covered.
bool can_be_covered(const Mesh& mesh, std::size_t holes) {
    const Clusters clusters = clusters_of(mesh);
    EXPECT_EQ(clusters.solids.size(), 1U);
    EXPECT_FALSE(clusters.solids[0].is_watertight);
    EXPECT_EQ(clusters.solids[0].hole_count, holes);
    EXPECT_EQ(clusters.holes.size(), holes);
    return clusters.solids[0].is_watertight_covered;
}

TEST(Holes, OfABallAreFoundWithTheirRims) {
    const Mesh mesh = ball_without({{0, 1, 0}, {1, 0, 0}}, 0.25);
    ASSERT_TRUE(can_be_covered(mesh, 2));
    const Surface surface = flatten(scene_of(mesh));
    const Clusters clusters = make_clusters(surface);
    std::size_t corners = 0;
    for (const Hole& hole : clusters.holes) {
        EXPECT_EQ(hole.first_corner, corners);
        corners += hole.corner_count;
        EXPECT_GE(hole.corner_count, 6U);
        EXPECT_LT(hole.bounds.radius, 0.35);
        for (std::uint32_t i = 0; i < hole.corner_count; ++i) {
            const glm::dvec3 p = surface.p_world[clusters.rims[hole.first_corner + i]];
            EXPECT_LE(glm::distance(p, hole.bounds.center_world), hole.bounds.radius);
        }
        const glm::dvec3 way = glm::normalize(hole.apex_world);
        EXPECT_GT(std::max(way.x, way.y), 0.99);
    }
    EXPECT_EQ(clusters.rims.size(), corners);
}

TEST(Holes, OfASolidThatIsClosedAreNone) {
    const Clusters clusters = clusters_of(unit_cube());
    EXPECT_TRUE(clusters.solids[0].is_watertight);
    EXPECT_EQ(clusters.solids[0].hole_count, 0U);
    EXPECT_FALSE(clusters.solids[0].is_watertight_covered);
}

TEST(Holes, OneTriangleAndAFaceOfACubeCanBeCovered) {
    Mesh ball = catalogue::make_icosphere(1, 3);
    ball.triangles.pop_back();
    EXPECT_TRUE(can_be_covered(ball, 1));
    Mesh cube = unit_cube();  // half a face: the rest of it lies in the plane of the fan
    cube.triangles.pop_back();
    EXPECT_FALSE(can_be_covered(cube, 1)) << "its ball is larger than half the cube";
    Mesh long_box = unit_cube();
    long_box.triangles.pop_back();
    for (glm::vec3& p : long_box.positions)
        p.x *= 20;
    EXPECT_TRUE(can_be_covered(long_box, 1));
}

TEST(Holes, ThatAreLargeCannotBeCovered) {
    EXPECT_FALSE(can_be_covered(catalogue::make_sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 1));
    EXPECT_FALSE(can_be_covered(ball_without({{0, 1, 0}}, 1.2), 1));
    EXPECT_TRUE(can_be_covered(ball_without({{0, 1, 0}}, 0.7), 1));
}

TEST(Holes, OfWhatIsInsideOutCannotBeCovered) {
    Mesh mesh = ball_without({{0, 1, 0}}, 0.3);
    for (Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]);
    EXPECT_FALSE(can_be_covered(mesh, 1));
}

TEST(Holes, ThatMeetInACornerOrAreBesideOtherFaultsAreNone) {
    Mesh mesh = catalogue::make_icosphere(1, 3);
    const Triangle first = mesh.triangles[0];
    const auto shares = [&](const Triangle& t) {
        return std::count_if(t.begin(), t.end(), [&](std::uint32_t v) {
            return std::find(first.begin(), first.end(), v) != first.end();
        });
    };
    const auto other = std::find_if(
        mesh.triangles.begin(), mesh.triangles.end(), [&](auto& t) { return shares(t) == 1; });
    ASSERT_NE(other, mesh.triangles.end());
    mesh.triangles.erase(other);
    mesh.triangles.erase(mesh.triangles.begin());
    EXPECT_FALSE(can_be_covered(mesh, 0));

    Mesh turned = ball_without({{0, 1, 0}}, 0.3);
    std::swap(turned.triangles[70][0], turned.triangles[70][1]);
    EXPECT_FALSE(can_be_covered(turned, 0));
}

TEST(Holes, ThatAreTooManyAreNone) {
    std::vector<glm::dvec3> points;
    for (std::size_t i = 0; i <= kMostHoles; ++i) {
        const double turn = 2 * std::numbers::pi * static_cast<double>(i) / (kMostHoles + 1);
        points.emplace_back(std::cos(turn), 0, std::sin(turn));
    }
    EXPECT_FALSE(can_be_covered(ball_without(points, 0.08, 5), 0));
    points.pop_back();
    EXPECT_TRUE(can_be_covered(ball_without(points, 0.08, 5), kMostHoles));
}

TEST(Holes, WhoseFanIsPiercedAreNotCovered) {
    const Mesh mesh = ball_without({{0, 1, 0}}, 0.4, 5);
    for (const double tip : {0.5, 1.2}) {
        const Mesh spiked = with_spike(mesh, tip);
        // The spike stands in the hole's ball, with what is left of it together.
        EXPECT_TRUE(can_be_covered(spiked, 1));
        EXPECT_EQ(clusters_of(spiked).holes[0].is_covered, tip < 1);
    }
    EXPECT_FALSE(can_be_covered(with_spike(mesh, 4), 1)) << "its tip is cut off by the ball";
}

/// A long ball without a band across, `half_turn_rad` to either side of z.
Mesh with_band(double half_turn_rad) {
    Mesh mesh = catalogue::make_icosphere(1, 5);
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
        const glm::dvec3 middle =
            glm::dvec3(mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0;
        return std::abs(middle.x) < 0.03 &&
               std::abs(std::atan2(middle.y, middle.z)) < half_turn_rad;
    });
    for (glm::vec3& p : mesh.positions)
        p.x *= 8;
    return mesh;
}

TEST(Holes, WhoseRimIsBentFarAreNotCovered) {
    EXPECT_TRUE(can_be_covered(with_band(0.8), 1));
    EXPECT_FALSE(clusters_of(with_band(0.8)).holes[0].is_covered) << "the fan is folded";
    EXPECT_FALSE(can_be_covered(with_band(2.8), 1)) << "its ball cuts the rest in two";
}

/// The law: from outside, a sight line that meets the back of a face first has come in through a
/// triangle of a fan that faces the eye.
TEST(Holes, LetBacksBeSeenThroughTheirFansAlone) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    const Mesh mesh = with_spike(ball_without({{0, 1, 0}, {0.6, 0, 0.8}}, 0.35), 0.5);
    const Surface surface = flatten(scene_of(mesh));
    const Clusters clusters = make_clusters(surface);
    ASSERT_TRUE(clusters.solids[0].is_watertight_covered);
    std::size_t backs = 0;
    for (int trial = 0; trial < 6000; ++trial) {
        const glm::dvec3 eye =
            glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))) * 3.0;
        const glm::dvec3 way =
            glm::dvec3(normal(random), normal(random), normal(random)) * 0.4 - eye;
        // Where along `way` a triangle is met; -1: nowhere.
        const auto meet = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
            const glm::dvec3 far = eye + way * 4.0;
            const int u = orient3d(eye, far, a, b), v = orient3d(eye, far, b, c);
            if (u != v || v != orient3d(eye, far, c, a)) return -1.0;
            const glm::dvec3 n = glm::cross(b - a, c - a);
            return glm::dot(n, a - eye) / glm::dot(n, way);
        };
        double nearest = 1e9;
        bool is_back = false;
        for (const auto& [a, b, c] : surface.triangles) {
            const auto& p = surface.p_world;
            const double at = meet(p[a], p[b], p[c]);
            if (at < 0 || at >= nearest) continue;
            nearest = at;
            is_back = facing(p[a], p[b], p[c], eye) < 0;
        }
        if (!is_back) continue;
        ++backs;
        bool has_come_in = false;
        for (const Hole& hole : clusters.holes) {
            std::vector<glm::dvec3> rim;
            for (std::uint32_t i = 0; i < hole.corner_count; ++i)
                rim.push_back(surface.p_world[clusters.rims[hole.first_corner + i]]);
            bool meets_fan = false;
            for (std::size_t i = 0; i < rim.size(); ++i) {
                const glm::dvec3 &a = rim[(i + 1) % rim.size()], &b = rim[i];
                const double at = meet(a, b, hole.apex_world);
                meets_fan = meets_fan ||
                            (at >= 0 && at < nearest && facing(a, b, hole.apex_world, eye) > 0);
            }
            EXPECT_TRUE(hole.is_covered);
            EXPECT_TRUE(!meets_fan || may_face(hole, rim, {eye}));
            has_come_in = has_come_in || meets_fan;
        }
        EXPECT_TRUE(has_come_in);
    }
    EXPECT_GT(backs, 50U);
}

TEST(Holes, AreLookedAtAnewWhenTheSurfaceMoves) {
    const Mesh mesh = ball_without({{0, 1, 0}}, 0.4, 4);
    const Surface still = flatten(scene_of(mesh));
    const Surface pierced = flatten(scene_of(with_spike(mesh, 4)));
    Clusters clusters = make_clusters(still);
    ASSERT_TRUE(clusters.solids[0].is_watertight_covered);
    const Hole before = clusters.holes[0];
    refresh(pierced, clusters);
    EXPECT_FALSE(clusters.solids[0].is_watertight_covered);
    Surface moved = still;
    for (glm::dvec3& p : moved.p_world)
        p = p * 2.0 + glm::dvec3(1, 2, 3);
    refresh(moved, clusters);
    EXPECT_TRUE(clusters.solids[0].is_watertight_covered);
    EXPECT_NEAR(clusters.holes[0].bounds.radius, 2 * before.bounds.radius, 1e-9);
    EXPECT_NEAR(clusters.holes[0].apex_world.y, 2 * before.apex_world.y + 2, 1e-9);
}

}  // namespace
}  // namespace ink::scene
