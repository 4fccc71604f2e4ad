#include "catalogue/cage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/topology.h"
#include "tests/scene/edge_counts.h"
#include "tests/scene/small_meshes.h"

namespace ink::catalogue {
namespace {

/// The cube of half side 1 as a cage.
Cage cube_cage() {
    const Ring rings[] = {{{1, -1, 1}, {1, -1, -1}, {-1, -1, -1}, {-1, -1, 1}},
                          {{1, 1, 1}, {1, 1, -1}, {-1, 1, -1}, {-1, 1, 1}}};
    return cage_of_rings(rings);
}

void expect_closed(const scene::Mesh& mesh) {
    const scene::Topology topology = scene::weld(scene::scene_of(mesh));
    const scene::EdgeCounts edges = scene::edge_counts(topology);
    EXPECT_EQ(edges.boundary, 0U);
    EXPECT_EQ(edges.nonmanifold, 0U);
    EXPECT_EQ(edges.inconsistent, 0U);
    EXPECT_EQ(topology.counts.degenerate, 0U);
}

TEST(Cage, ACubeSubdividedOnceHasTheAverages) {
    const scene::Mesh mesh = subdivided(cube_cage(), 1);
    ASSERT_EQ(mesh.positions.size(), 8U + 12 + 6);
    EXPECT_EQ(mesh.triangles.size(), 6U * 4 * 2);
    // A corner: faces' middles average 1/3, edges' 2/3, and (F + 2 E + 0 P) / 3 = 5/9 an axis.
    EXPECT_NEAR(std::abs(mesh.positions[0].x), 5.0 / 9, 1e-6);
    // An edge's middle: (1 + 1 + 1 + 0) / 4 along two axes, 0 along the third.
    EXPECT_NEAR(glm::length(mesh.positions[8]), std::sqrt(2.0) * 0.75, 1e-6);
    expect_closed(mesh);
}

TEST(Cage, AFaceIsPulledOutAlongItsStations) {
    Cage cage = cube_cage();
    const std::size_t top = cage.faces.size() - 1;
    const TubeNode stations[] = {{{0, 2, 0}, 0.5}, {{0, 3, 0}, 0.25}};
    pull(cage, top, stations);
    EXPECT_EQ(cage.faces.size(), 6U + 2 * 4);
    for (const auto corner : cage.faces[top]) {
        EXPECT_NEAR(cage.points[corner].y, 3, 1e-12);
        EXPECT_NEAR(
            glm::length(glm::dvec2(cage.points[corner].x, cage.points[corner].z)), 0.25, 1e-12);
    }
    expect_closed(subdivided(cage, 2));
}

TEST(Cage, APulledFaceTurnsWithItsPath) {
    Cage cage = cube_cage();
    const std::size_t top = cage.faces.size() - 1;
    const TubeNode stations[] = {{{0, 2, 0}, 0.5}, {{1, 3, 0}, 0.5}, {{2, 3, 0}, 0.5}};
    pull(cage, top, stations);
    for (const auto corner : cage.faces[top])
        EXPECT_NEAR(cage.points[corner].x, 2, 1e-12) << "the end stands across +x";
    expect_closed(subdivided(cage, 2));
}

}  // namespace
}  // namespace ink::catalogue
