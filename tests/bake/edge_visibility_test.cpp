#include "bake/edge_visibility.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "methods/surface_codes/baked_codes.h"
#include "scene/scene.h"

namespace ink::bake {
namespace {

using testing::ElementsAre;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

constexpr double kCrease_deg = 40;

std::vector<int> numbers_of(const std::vector<std::byte>& bytes) {
    std::vector<int> numbers;
    for (const std::byte byte : bytes)
        numbers.push_back(std::to_integer<int>(byte));
    return numbers;
}

scene::Scene scene_of(const std::vector<glm::vec3>& positions,
                      const std::vector<scene::Triangle>& triangles,
                      const glm::dmat4& world_from_object = glm::dmat4(1)) {
    scene::Scene scene;
    scene.name = "made";
    scene.meshes.push_back({.name = "mesh",
                            .positions = positions,
                            .normals = {},
                            .triangles = triangles,
                            .materials = {}});
    scene.instances.push_back({0, world_from_object, "object"});
    return scene;
}

SceneEdges edges_of(const scene::Scene& scene) {
    const scene::PreparedScene prepared(scene);
    return find_edges(prepared, *methods::baked_mesh(prepared, kCrease_deg));
}

std::vector<std::uint8_t> values_of(const scene::Scene& scene) {
    const SceneEdges edges = edges_of(scene);
    return edge_visibility(edges.of_triangle, edges.edges);
}

std::ptrdiff_t count(const std::vector<std::uint8_t>& values, EdgeVisibility value) {
    return std::count(values.begin(), values.end(), value);
}

// The specification's own example, of the triangles (0,1,2) and (0,2,3): edges 0-1 and 2-3 are
// hard, 1-2 and 3-0 hidden, the diagonal 0-2 is a silhouette.
TEST(EdgeVisibility, TwoTrianglesOfTheSpecification) {
    const std::vector<KnownEdge> edges{{EdgeKind::hard},
                                       {EdgeKind::hidden},
                                       {EdgeKind::silhouette},
                                       {EdgeKind::hard},
                                       {EdgeKind::hidden}};
    const auto values = edge_visibility(Triangles{{0, 1, 2}, {2, 3, 4}}, edges);
    EXPECT_THAT(values, ElementsAre(2, 0, 1, 0, 2, 0));
    EXPECT_THAT(numbers_of(packed_visibility(values)), ElementsAre(18, 2));
}

TEST(EdgeVisibility, ASharedHardEdgeIsEncodedOnceAndRepeated) {
    const std::vector<KnownEdge> edges{{EdgeKind::hard},
                                       {EdgeKind::hidden},
                                       {EdgeKind::hard},
                                       {EdgeKind::hard},
                                       {EdgeKind::hidden}};
    const auto values = edge_visibility(Triangles{{0, 1, 2}, {2, 3, 4}}, edges);
    EXPECT_THAT(values, ElementsAre(2, 0, 2, 3, 2, 0));
    EXPECT_THAT(numbers_of(packed_visibility(values)), ElementsAre(226, 2));
}

TEST(EdgeVisibility, TakesTwoBitsAnEdge) {
    for (std::size_t triangles = 0; triangles < 9; ++triangles)
        EXPECT_EQ(packed_visibility(std::vector<std::uint8_t>(3 * triangles, 1)).size(),
                  (6 * triangles + 7) / 8);
}

const std::vector<glm::vec3> kCubeCorners{
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const std::vector<scene::Triangle> kCubeTriangles{{0, 2, 1},
                                                  {0, 3, 2},
                                                  {4, 5, 6},
                                                  {4, 6, 7},
                                                  {0, 1, 5},
                                                  {0, 5, 4},
                                                  {1, 2, 6},
                                                  {1, 6, 5},
                                                  {2, 3, 7},
                                                  {2, 7, 6},
                                                  {3, 0, 4},
                                                  {3, 4, 7}};

TEST(EdgeKinds, ACubeHasTwelveHardEdgesAndHiddenDiagonals) {
    const auto values = values_of(scene_of(kCubeCorners, kCubeTriangles));
    EXPECT_EQ(count(values, kHard), 12);
    EXPECT_EQ(count(values, kHardAgain), 12);
    EXPECT_EQ(count(values, kSilhouette), 0);
    EXPECT_EQ(count(values, kHidden), 12);
}

TEST(EdgeKinds, ASplitCubeIsTheSame) {
    // As exporters have it: no vertex shared, welded by place.
    std::vector<glm::vec3> positions;
    std::vector<scene::Triangle> triangles;
    for (const scene::Triangle& triangle : kCubeTriangles) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        for (const std::uint32_t v : triangle)
            positions.push_back(kCubeCorners[v]);
        triangles.push_back({first, first + 1, first + 2});
    }
    EXPECT_EQ(values_of(scene_of(positions, triangles)),
              values_of(scene_of(kCubeCorners, kCubeTriangles)));
}

TEST(EdgeKinds, AMirroredCubeHasTheSameEdges) {
    glm::dmat4 mirror(1);
    mirror[0][0] = -1;
    EXPECT_EQ(values_of(scene_of(kCubeCorners, kCubeTriangles, mirror)),
              values_of(scene_of(kCubeCorners, kCubeTriangles)));
}

TEST(EdgeKinds, DoubledFacesRepeatTheirEdges) {
    std::vector<scene::Triangle> triangles = kCubeTriangles;
    for (const auto& [a, b, c] : kCubeTriangles)
        triangles.push_back({c, b, a});
    const auto values = values_of(scene_of(kCubeCorners, triangles));
    EXPECT_EQ(count(values, kHard), 12);
    EXPECT_EQ(count(values, kHardAgain), 36);
}

TEST(EdgeKinds, ABendIsASilhouetteUntilItIsACrease) {
    // Two triangles on a common edge along z, bent by an angle about it.
    const auto bent = [](double bend_deg) {
        const double rad = glm::radians(bend_deg);
        return values_of(
            scene_of({{0, 0, 0},
                      {0, 0, 1},
                      {1, 0, 0},
                      {static_cast<float>(-std::cos(rad)), static_cast<float>(std::sin(rad)), 0}},
                     {{0, 1, 2}, {1, 0, 3}}));
    };
    EXPECT_THAT(bent(0), ElementsAre(0, 2, 2, 0, 2, 2));
    EXPECT_THAT(bent(39), ElementsAre(1, 2, 2, 0, 2, 2));
    EXPECT_THAT(bent(41), ElementsAre(2, 2, 2, 3, 2, 2));
}

TEST(EdgeKinds, NoLineRunsAlongATJunctionOfAPlane) {
    // Below a triangle on 0..2, above two on 0..1 and 1..2.
    const auto values = values_of(
        scene_of({{0, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, 0, 0}, {0.5F, 1, 0}, {1.5F, 1, 0}},
                 {{0, 2, 1}, {0, 3, 4}, {3, 1, 5}}));
    EXPECT_THAT(values, ElementsAre(2, 2, 0, 0, 2, 2, 0, 2, 2));
}

TEST(EdgeKinds, ABentTJunctionIsDrawnOnce) {
    // The upper ones lean back: their two edges are silhouettes, the long one is hidden.
    const auto values = values_of(
        scene_of({{0, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, 0, 0}, {0.5F, 1, 0.3F}, {1.5F, 1, 0.3F}},
                 {{0, 2, 1}, {0, 3, 4}, {3, 1, 5}}));
    EXPECT_THAT(values, ElementsAre(2, 2, 0, 1, 2, 2, 1, 2, 2));
}

TEST(EdgeKinds, AnEdgeOfThreeFacesIsHard) {
    const auto values = values_of(scene_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}},
                                           {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
    EXPECT_THAT(values, ElementsAre(2, 2, 2, 3, 2, 2, 3, 2, 2));
}

TEST(EdgeKinds, TrianglesWithoutAreaHaveNoEdgesOfTheirOwn) {
    const auto values =
        values_of(scene_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 0, 1}, {2, 2, 2}}));
    EXPECT_THAT(values, ElementsAre(2, 2, 2, 0, 3, 3, 0, 0, 0));
}

}  // namespace
}  // namespace ink::bake
