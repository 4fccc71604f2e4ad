#include "catalogue/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "catalogue/catalogue_stage.h"
#include "scene/topology.h"
#include "tests/scene/edge_counts.h"
#include "tests/scene/small_meshes.h"

namespace ink::catalogue {
namespace {

constexpr double kPi = std::numbers::pi;

/// Positive where the triangles run counter-clockwise seen from outside.
double volume(const scene::Mesh& mesh) {
    double six_volumes = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::dvec3 p(mesh.positions[a]);
        six_volumes +=
            glm::dot(p, glm::cross(glm::dvec3(mesh.positions[b]), glm::dvec3(mesh.positions[c])));
    }
    return six_volumes / 6;
}

/// Vertices - edges + faces: 2 for a ball, 0 for a ring.
long euler_characteristic(const scene::Topology& topology) {
    return static_cast<long>(topology.p_world.size()) - static_cast<long>(topology.edges.size()) +
           static_cast<long>(topology.faces.size());
}

void expect_closed(const scene::Mesh& mesh, long euler) {
    const scene::Topology topology = scene::weld(scene::scene_of(mesh));
    EXPECT_EQ(topology.counts.degenerate, 0U);
    EXPECT_EQ(topology.counts.duplicate, 0U);
    EXPECT_EQ(scene::edge_counts(topology).boundary, 0U);
    EXPECT_EQ(scene::edge_counts(topology).nonmanifold, 0U);
    EXPECT_EQ(scene::edge_counts(topology).inconsistent, 0U);
    EXPECT_EQ(topology.p_world.size(), mesh.positions.size()) << "a vertex was stored twice";
    EXPECT_EQ(euler_characteristic(topology), euler);
}

/// The area of the regular polygon that a circle of `radius` is drawn as.
double polygon_area(double radius, int sides) {
    return 0.5 * sides * radius * radius * std::sin(2 * kPi / sides);
}

TEST(Shapes, BallsAreClosedAndFaceOutwards) {
    const scene::Mesh globe = make_sphere(1, 64, 32);
    expect_closed(globe, 2);
    EXPECT_EQ(globe.triangles.size(), 2U * 64 * 31);
    EXPECT_NEAR(volume(globe), 4 * kPi / 3, 0.02);
    EXPECT_LT(volume(globe), 4 * kPi / 3);

    const scene::Mesh icosphere = make_icosphere(1, 3);
    expect_closed(icosphere, 2);
    EXPECT_EQ(icosphere.triangles.size(), 20U * 64);
    EXPECT_NEAR(volume(icosphere), 4 * kPi / 3, 0.04);
}

TEST(Shapes, TorusIsARing) {
    const scene::Mesh torus = make_torus({1, 0.4}, {96, 40});
    expect_closed(torus, 0);
    EXPECT_NEAR(volume(torus), 2 * kPi * kPi * 0.16, 0.03);
}

TEST(Shapes, PrismsAndPyramidsHaveTheirVolumes) {
    expect_closed(make_box({-1, -2, -3}, {1, 2, 3}), 2);
    EXPECT_DOUBLE_EQ(volume(make_box({-1, -2, -3}, {1, 2, 3})), 48);
    expect_closed(make_cylinder(0.7, 2, 6), 2);
    EXPECT_NEAR(volume(make_cylinder(0.7, 2, 6)), 2 * polygon_area(0.7, 6), 1e-5);
    expect_closed(make_cone(0.7, 2, 9), 2);
    EXPECT_NEAR(volume(make_cone(0.7, 2, 9)), 2 * polygon_area(0.7, 9) / 3, 1e-5);
}

TEST(Shapes, SheetFacesUCrossV) {
    const scene::Mesh sheet = make_sheet({0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {4, 5});
    EXPECT_EQ(sheet.triangles.size(), 40U);
    for (const auto& [a, b, c] : sheet.triangles) {
        const auto& p = sheet.positions;
        EXPECT_GT(glm::cross(p[b] - p[a], p[c] - p[a]).z, 0);
    }
}

TEST(Shapes, ExtrudedConcaveOutlineKeepsItsArea) {
    const glm::dvec2 arrow[] = {{0, 0}, {2, -1}, {1, 0}, {2, 1}};  // area 1
    const scene::Mesh solid = extrude(arrow, {-0.5, 1.5});
    expect_closed(solid, 2);
    EXPECT_DOUBLE_EQ(volume(solid), 2);
    EXPECT_EQ(solid.triangles.size(), 2U * 4 + 2 * 2);
}

TEST(Shapes, TubesAreClosedAndFaceOutwards) {
    const TubeNode deviation[] = {
        {{0, 0, 0}, 0.1}, {{0, 1, 0}, 0.1}, {{1, 1.5, 0.5}, 0.2}, {{2, 1, 1}, 0.1}};
    const scene::Mesh tube = make_tube(smoothed(deviation, 8), 16);
    expect_closed(tube, 2);
    EXPECT_GT(volume(tube), 0);

    std::vector<TubeNode> circle;
    for (const auto& p : unit_circle(64))
        circle.push_back({p, 0.25});
    const scene::Mesh ring = make_closed_tube(circle, 24);
    expect_closed(ring, 0);
    EXPECT_NEAR(volume(ring), 2 * kPi * kPi / 16, 0.03);
}

TEST(Shapes, SmoothedPathGoesThroughItsNodes) {
    const TubeNode nodes[] = {{{0, 0, 0}, 1}, {{1, 2, 0}, 2}, {{3, 1, 1}, 3}};
    const auto path = smoothed(nodes, 4);
    ASSERT_EQ(path.size(), 9U);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(path[4 * i].center, nodes[i].center);
        EXPECT_EQ(path[4 * i].radius, nodes[i].radius);
    }
}

TEST(Shapes, MirroringKeepsTheOutsideOutside) {
    const scene::Mesh cone = make_cone(1, 2, 12);
    const scene::Mesh mirrored = moved(cone, placed({{1, 2, 3}, {10, 20, 30}, {-1, 1, 1}}));
    EXPECT_NEAR(volume(mirrored), volume(cone), 1e-5);
}

TEST(Shapes, PositionsLieOnTheirGrid) {
    for (const glm::vec3& p : make_icosphere(1.3, 2).positions) {
        for (int axis = 0; axis < 3; ++axis) {
            const double steps = static_cast<double>(p[axis]) * (1 << 20);
            EXPECT_EQ(steps, std::round(steps));
            EXPECT_FALSE(p[axis] == 0 && std::signbit(p[axis]));
        }
    }
}

TEST(Teapot, FacesOutwards) {
    const Teapot teapot = make_teapot(8);
    // Divergence theorem on open pieces: near enough closed about a point inside each.
    EXPECT_GT(volume(moved(teapot.body, placed({{0, -1.2, 0}}))), 10);
    EXPECT_GT(volume(moved(teapot.lid, placed({{0, -2.4, 0}}))), 0.1);
    EXPECT_GT(volume(moved(teapot.handle, placed({{1.75, -1.4, 0}}))), 0.1);
    EXPECT_GT(volume(moved(teapot.spout, placed({{-2.3, -1.5, 0}}))), 0.1);
}

/// Every 151st vertex of the published teapot, whose patches have ten cuts.
constexpr glm::dvec3 kPublished[] = {{-3, 1.8, 0},
                                     {-2.683107, 1.63861, -0.081},
                                     {-2.2896, 2.0106, 0},
                                     {-1.820003, 1.621875, -0.302522},
                                     {-1.495635, 2.242575, 0.502408},
                                     {-1.312948, 0.0648, -0.441041},
                                     {-1.07494, 0.177075, -1.07494},
                                     {-0.821035, 0.0648, -1.118749},
                                     {-0.529441, 0.0312, 1.017621},
                                     {-0.309596, 2.5272, 0.921647},
                                     {-0.195658, 2.86335, 0.101925},
                                     {-0.062272, 3.14145, -0.18487},
                                     {0, 2.4, -1.4},
                                     {0.063808, 2.7, -0.189952},
                                     {0.197424, 2.7, -0.032816},
                                     {0.310439, 0.553725, 1.867631},
                                     {0.534711, 0.3168, 1.591798},
                                     {0.823129, 2.435437, 1.121601},
                                     {1.086029, 2.5026, 0.180521},
                                     {1.316296, 2.435437, 0.442166},
                                     {1.496475, 0.127575, 0},
                                     {1.896, 1.4712, 0},
                                     {2.5819, 1.56915, 0.3276},
                                     {2.922899, 2.450567, 0.143892},
                                     {3.368813, 2.470934, 0.103104}};

TEST(Teapot, LiesOnThePublishedOne) {
    const Teapot teapot = make_teapot(10);
    for (const glm::dvec3& p : kPublished) {
        double nearest = 1e9;
        for (const scene::Mesh* mesh : {&teapot.body, &teapot.lid, &teapot.handle, &teapot.spout}) {
            for (const glm::dvec3 q : mesh->positions)
                nearest = std::min(nearest, glm::distance(p, q));
        }
        EXPECT_LT(nearest, 5e-6) << p.x << ' ' << p.y << ' ' << p.z;
    }
}

}  // namespace
}  // namespace ink::catalogue
