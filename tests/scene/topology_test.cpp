#include "scene/topology.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/scene/edge_counts.h"
#include "tests/scene/small_meshes.h"

namespace ink::scene {
namespace {

Mesh triangles(std::vector<glm::vec3> positions, std::vector<Triangle> faces) {
    Mesh mesh;
    mesh.name = "made";
    mesh.positions = std::move(positions);
    mesh.triangles = std::move(faces);
    return mesh;
}

TEST(Weld, CubeSoupClosesToEightVerticesAndEighteenEdges) {
    const Topology topology = weld(scene_of(exploded(unit_cube())));
    EXPECT_EQ(topology.p_world.size(), 8U);
    EXPECT_EQ(topology.faces.size(), 12U);
    EXPECT_EQ(topology.edges.size(), 18U);  // 12 of the cube, 6 diagonals
    EXPECT_EQ(edge_counts(topology).boundary, 0U);
    EXPECT_EQ(edge_counts(topology).nonmanifold, 0U);
    EXPECT_EQ(edge_counts(topology).inconsistent, 0U);
}

TEST(Weld, JoinsOverMeshesAndInstances) {
    Scene scene = scene_of(unit_cube());
    scene.instances.push_back({0, glm::translate(glm::dmat4(1), glm::dvec3(2, 0, 0)), "neighbour"});
    const Topology topology = weld(scene);
    EXPECT_EQ(topology.p_world.size(), 12U);   // the shared square counts once
    EXPECT_EQ(topology.counts.duplicate, 2U);  // and its two triangles are there twice
    EXPECT_EQ(topology.faces.back().object, 1U);
}

TEST(Weld, MinusZeroIsZero) {
    const Topology topology = weld(scene_of(
        triangles({{0.F, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.F, 0, -0.F}, {0, -1, 0}, {1, 0, -0.F}},
                  {{0, 1, 2}, {3, 4, 5}})));
    EXPECT_EQ(topology.p_world.size(), 4U);
}

TEST(Weld, CountsWhatItDrops) {
    const Topology topology = weld(
        scene_of(triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 0, 0}},
                           {{0, 1, 2}, {2, 0, 1}, {0, 2, 1}, {0, 1, 3}, {0, 1, 4}, {0, 0, 1}})));
    EXPECT_EQ(topology.faces.size(), 1U);
    EXPECT_EQ(topology.counts.triangles, 6U);
    EXPECT_EQ(topology.counts.duplicate, 2U);   // in any order and orientation
    EXPECT_EQ(topology.counts.degenerate, 3U);  // collinear, welded corners, equal corners
    EXPECT_EQ(edge_counts(topology).boundary, 3U);
}

TEST(Weld, ListsTheTrianglesThatAreNoFacesAndWhichOnesTheyRepeat) {
    const Scene scene =
        scene_of(triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1e-3F, 0}},
                           {{0, 0, 1}, {0, 1, 2}, {2, 1, 0}, {3, 1, 2}, {0, 3, 1}}));
    const Topology exact = weld(scene);
    ASSERT_EQ(exact.lost.size(), 2U);
    EXPECT_EQ(exact.lost[0].triangle, 0U);
    EXPECT_EQ(exact.lost[0].face, LostTriangle::kNoFace);
    EXPECT_EQ(exact.lost[1].triangle, 2U);
    EXPECT_EQ(exact.lost[1].face, 0U);
    const Topology joined = weld(scene, {.epsilon = 0.01});
    ASSERT_EQ(joined.lost.size(), 4U);
    EXPECT_EQ(joined.lost[2].triangle, 3U);  // alike only because a corner moved
    EXPECT_EQ(joined.lost[2].face, LostTriangle::kNoFace);
    EXPECT_EQ(joined.lost[2].vertices, joined.faces[0].vertices);
}

TEST(Weld, NonManifoldAndInconsistentEdgesAreCounted) {
    // A fin: three triangles on the edge (0,1); and two that both run 0 -> 1.
    const std::vector<glm::vec3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    const Topology fin = weld(scene_of(triangles(p, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})));
    EXPECT_EQ(edge_counts(fin).nonmanifold, 1U);
    const Topology twisted = weld(scene_of(triangles(p, {{0, 1, 2}, {0, 1, 3}})));
    EXPECT_EQ(edge_counts(twisted).inconsistent, 1U);
}

TEST(Weld, AMirroredInstanceKeepsItsFrontsOutside) {
    Scene scene = scene_of(unit_cube());
    scene.instances[0].world_from_object = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
    const Topology topology = weld(scene);
    for (const Face& face : topology.faces) {
        const glm::dvec3 a = topology.p_world[face.vertices[0]];
        const glm::dvec3 n = glm::cross(topology.p_world[face.vertices[1]] - a,
                                        topology.p_world[face.vertices[2]] - a);
        EXPECT_GT(glm::dot(n, a), 0);
    }
}

TEST(Bend, IsZeroWhenFlatAndARightAngleOnACube) {
    const Topology topology = weld(scene_of(unit_cube()));
    int flat = 0, right = 0;
    for (const Edge& edge : topology.edges) {
        const auto faces = topology.faces_of(edge);
        const double deviation = deviation_rad(topology, edge, faces[0], faces[1]);
        flat += std::abs(deviation) < 1e-12;
        right += std::abs(deviation - std::numbers::pi / 2) < 1e-12;
    }
    EXPECT_EQ(flat, 6);
    EXPECT_EQ(right, 12);
}

TEST(Weld, AnEmptySceneIsAnEmptyTopology) {
    const Topology topology = weld(Scene{});
    EXPECT_TRUE(topology.faces.empty());
    EXPECT_TRUE(topology.edges.empty());
}

}  // namespace
}  // namespace ink::scene
