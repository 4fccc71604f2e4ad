#include <gtest/gtest.h>

#include <algorithm>

#include "scene/topology.h"
#include "tests/scene/edge_counts.h"
#include "tests/scene/small_meshes.h"

namespace ink::import {
namespace {

/// The cube's triangles, three vertices each, every vertex off by up to `shift` in each axis.
scene::Mesh cracked_cube(float shift) {
    scene::Mesh soup = scene::exploded(scene::unit_cube());
    int k = 0;
    for (glm::vec3& p : soup.positions) {
        p += shift * glm::vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
        ++k;
    }
    return soup;
}

void expect_closed_cube(const scene::Topology& topology) {
    EXPECT_EQ(topology.p_world.size(), 8U);
    EXPECT_EQ(topology.faces.size(), 12U);
    EXPECT_EQ(topology.edges.size(), 18U);
    EXPECT_EQ(scene::edge_counts(topology).boundary, 0U);
    EXPECT_EQ(topology.counts.collapsed, 0U);
}

bool same(const scene::Topology& a, const scene::Topology& b) {
    const auto same_face = [](const scene::Face& f, const scene::Face& g) {
        return f.vertices == g.vertices && f.edges == g.edges && f.object == g.object &&
               f.triangle == g.triangle;
    };
    return a.p_world == b.p_world && a.edge_faces == b.edge_faces &&
           std::equal(a.faces.begin(), a.faces.end(), b.faces.begin(), b.faces.end(), same_face);
}

TEST(WeldEpsilon, ClosesASoupWithCracks) {
    const scene::Scene scene = scene::scene_of(cracked_cube(1e-5F));
    EXPECT_EQ(scene::edge_counts(scene::weld(scene)).boundary, 36U) << "every triangle for itself";
    // Corners lie at most 2e-5 sqrt(3) apart, the diagonal is 2 sqrt(3): a share of 1e-5.
    const scene::Topology closed = scene::weld(scene, {.epsilon = 1.2e-5});
    expect_closed_cube(closed);
    EXPECT_GT(closed.counts.joined_vertices, 8U);
    EXPECT_EQ(scene::edge_counts(scene::weld(scene, {.epsilon = 1e-7})).boundary, 36U);
}

TEST(WeldEpsilon, IsAShareOfEachPart) {
    // A large and a small soup with cracks of the same share of their size; what closes the large
    // one in absolute terms would swallow the small one whole.
    scene::Scene scene = scene::scene_of(cracked_cube(1e-5F));
    scene.instances[0].world_from_object = glm::scale(glm::dmat4(1), glm::dvec3(1e4));
    scene.instances.push_back(
        {0,
         glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(5e4, 0, 0)), glm::dvec3(1e-2)),
         "small"});
    const scene::Topology topology = scene::weld(scene, {.epsilon = 1.2e-5});
    EXPECT_EQ(topology.p_world.size(), 16U);
    EXPECT_EQ(topology.faces.size(), 24U);
    EXPECT_EQ(scene::edge_counts(topology).boundary, 0U);
}

TEST(WeldEpsilon, DoesNotDependOnTheOrderOfTriangles) {
    scene::Mesh mesh = cracked_cube(1e-5F);
    const scene::Topology straight = scene::weld(scene::scene_of(mesh), {.epsilon = 1.2e-5});
    std::reverse(mesh.triangles.begin(), mesh.triangles.end());
    const scene::Topology turned = scene::weld(scene::scene_of(mesh), {.epsilon = 1.2e-5});
    const auto sorted = [](std::vector<glm::dvec3> points) {
        std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
            return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
        });
        return points;
    };
    EXPECT_EQ(sorted(straight.p_world), sorted(turned.p_world));
}

TEST(WeldEpsilon, ZeroIsTheExactWeld) {
    const scene::Scene scene = scene::scene_of(cracked_cube(1e-5F));
    EXPECT_TRUE(same(scene::weld(scene), scene::weld(scene, {.epsilon = 0})));
    EXPECT_EQ(scene::weld(scene).counts.joined_vertices, 0U);
    // An epsilon below every gap moves nothing either.
    EXPECT_TRUE(same(scene::weld(scene), scene::weld(scene, {.epsilon = 1e-12})));
}

TEST(WeldEpsilon, CountsWhatCollapses) {
    // A sliver beside a large triangle: its short side is a thousandth of the diagonal.
    scene::Mesh mesh;
    mesh.name = "sliver";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0.001F, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 0, 1}};
    const scene::Topology exact = scene::weld(scene::scene_of(mesh));
    EXPECT_EQ(exact.faces.size(), 2U);
    EXPECT_EQ(exact.counts.degenerate, 1U);
    EXPECT_EQ(exact.counts.collapsed, 0U);
    const scene::Topology near = scene::weld(scene::scene_of(mesh), {.epsilon = 0.002});
    EXPECT_EQ(near.faces.size(), 1U);
    EXPECT_EQ(near.counts.degenerate, 2U);
    EXPECT_EQ(near.counts.collapsed, 1U);
    EXPECT_EQ(near.counts.joined_vertices, 1U);
}

TEST(WeldEpsilon, ClosesAtAMillionthWhatCollapsesTrianglesOfAFineScan) {
    const scene::Scene soup = scene::scene_of(cracked_cube(5e-7F));
    EXPECT_EQ(scene::edge_counts(scene::weld(soup)).boundary, 36U);
    EXPECT_EQ(scene::edge_counts(scene::weld(soup, {.epsilon = 1e-6})).boundary, 0U);
    // A sheet of 30 x 30 squares half a millionth wide, of a scene about as large as that cube.
    scene::Mesh scan;
    for (int i = 0; i < 31 * 31; ++i)
        scan.positions.emplace_back(1e-6 * (i % 31), 1e-6 * (i / 31), 0);
    for (std::uint32_t square = 0; square < 30 * 30; ++square) {
        const std::uint32_t at = square / 30 * 31 + square % 30;
        scan.triangles.push_back({at, at + 1, at + 32});
        scan.triangles.push_back({at, at + 32, at + 31});
    }
    scan.positions.insert(scan.positions.end(), {{2, 0, 0}, {0, 2, 0}, {0, 2, 2}});
    scan.triangles.push_back({31 * 31, 31 * 31 + 1, 31 * 31 + 2});
    const scene::Scene fine = scene::scene_of(scan);
    EXPECT_EQ(scene::weld(fine).counts.collapsed, 0U);
    EXPECT_GT(scene::weld(fine, {.epsilon = 1e-6}).counts.collapsed, 700U);
}

}  // namespace
}  // namespace ink::import
