#include "methods/edge_hash/soup_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "catalogue/shapes.h"
#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

constexpr double kCrease_rad = 0.7;

SoupModels posed(const scene::Scene& scene) {
    SoupModels models({.epsilon = 1e-5, .most_frames = 8, .crease_rad = kCrease_rad});
    models.prepare(scene);
    models.pose(scene);
    return models;
}

std::ptrdiff_t count(const std::vector<buffers::KnownEdge>& edges, buffers::EdgeKind kind) {
    return std::count_if(edges.begin(), edges.end(), [&](const buffers::KnownEdge& edge) {
        return edge.kind == kind;
    });
}

/// What the edge on the z axis is; none where it is not listed.
buffers::EdgeKind axis_kind(const SoupModels& models, const glm::dvec3& eye) {
    for (const buffers::KnownEdge& edge : models.lines({eye})) {
        if (edge.a_world + edge.b_world == glm::dvec3(0)) return edge.kind;
    }
    return buffers::EdgeKind::none;
}

/// Faces that all have the z axis from -1 to 1 as a side.
scene::Scene faces_on_the_axis(const std::vector<glm::vec3>& opposite) {
    scene::Mesh mesh;
    mesh.positions = {{0, 0, -1}, {0, 0, 1}};
    for (const glm::vec3& p : opposite) {
        mesh.positions.push_back(p);
        mesh.triangles.push_back({0, 1, static_cast<std::uint32_t>(mesh.positions.size() - 1)});
    }
    return scene_of({mesh});
}

TEST(SoupModels, WhichWayAFaceRunsDoesNotMatter) {
    scene::Scene roof = faces_on_the_axis({{-1, -1, 0}, {1, -1, 0}});
    for (const bool is_turned : {false, true}) {
        if (is_turned) std::swap(roof.meshes[0].triangles[0][0], roof.meshes[0].triangles[0][1]);
        const SoupModels models = posed(roof);
        EXPECT_EQ(axis_kind(models, {0, 5, 0}), buffers::EdgeKind::crease);
        EXPECT_EQ(axis_kind(models, {0.5, -5, 0.25}), buffers::EdgeKind::crease);  // from inside
        EXPECT_EQ(axis_kind(models, {5, 0, 0}), buffers::EdgeKind::contour);
        EXPECT_EQ(axis_kind(models, {-5, 1, 0}), buffers::EdgeKind::contour);
        EXPECT_EQ(axis_kind(models, {5, -5, 0}), buffers::EdgeKind::contour);  // one is edge-on
    }
}

TEST(SoupModels, OfThreeFacesTheTwoThatAreSeenDecide) {
    const SoupModels fin = posed(faces_on_the_axis({{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(axis_kind(fin, {2, 2, 0}), buffers::EdgeKind::crease);   // the fin hides the far half
    EXPECT_EQ(axis_kind(fin, {-2, 1, 0}), buffers::EdgeKind::crease);  // and here the other
    EXPECT_EQ(axis_kind(fin, {0.5, -2, 0}), buffers::EdgeKind::none);  // from below all is flat
    const SoupModels fan = posed(faces_on_the_axis({{-1, -1, 0}, {-1, 0, 0}, {-1, 1, 0}}));
    EXPECT_EQ(axis_kind(fan, {0.5, 5, 0}), buffers::EdgeKind::contour);  // all on one side
    EXPECT_EQ(axis_kind(fan, {-5, 0.5, 0}), buffers::EdgeKind::crease);  // between two of them
}

TEST(SoupModels, BoundaryEdgesAreSoFromEverywhere) {
    const SoupModels models = posed(faces_on_the_axis({{1, 0, 0}}));
    for (const glm::dvec3 eye : {glm::dvec3{0, 5, 0}, {0, -5, 0}, {5, 0, 0}})
        EXPECT_EQ(count(models.lines({eye}), buffers::EdgeKind::boundary), 3);
}

scene::Scene frame_of(double height) {
    scene::Scene scene = scene_of({cube_mesh(), floor_mesh(2)});
    for (glm::vec3& p : scene.meshes[0].positions)
        p.y *= static_cast<float>(height);
    return scene;
}

TEST(EdgeCache, FindsAFrameAgainWhenTheAnimationComesBackToIt) {
    SoupModels models({.most_frames = 8, .crease_rad = kCrease_rad});
    models.prepare(frame_of(1));
    EXPECT_EQ(models.cache_counts().built, 0U);
    models.pose(frame_of(1));
    EXPECT_EQ(models.cache_counts().built, 2U);  // cube and floor
    const auto first = models.lines({{3, 4, 5}});
    models.pose(frame_of(2));
    EXPECT_EQ(models.cache_counts().built, 3U);
    EXPECT_EQ(models.cache_counts().found, 1U);  // the floor
    EXPECT_NE(models.lines({{3, 4, 5}})[0].b_world, first[0].b_world);
    models.pose(frame_of(1));
    EXPECT_EQ(models.cache_counts().built, 3U);
    EXPECT_EQ(models.cache_counts().found, 3U);
    const auto again = models.lines({{3, 4, 5}});
    ASSERT_EQ(again.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(again[i].a_world, first[i].a_world);
        EXPECT_EQ(again[i].b_world, first[i].b_world);
        EXPECT_EQ(again[i].kind, first[i].kind);
    }
    models.prepare(frame_of(1));
    EXPECT_EQ(models.cache_counts().found, 0U);
}

TEST(EdgeCache, MovingAnObjectIsNoNewFrame) {
    SoupModels models({.most_frames = 8, .crease_rad = kCrease_rad});
    scene::Scene scene = frame_of(1);
    models.prepare(scene);
    models.pose(scene);
    scene.instances[0].world_from_object = glm::translate(glm::dmat4(1), {3, 0, 0});
    models.pose(scene);
    EXPECT_EQ(models.cache_counts().built, 2U);
}

TEST(EdgeCache, DropsTheFrameThatWasNotAskedForTheLongest) {
    SoupModels models({.most_frames = 2, .crease_rad = kCrease_rad});
    models.prepare(frame_of(1));
    for (const double height : {1.0, 2.0, 1.0, 3.0, 1.0})  // 3 drops 2
        models.pose(frame_of(height));
    EXPECT_EQ(models.cache_counts().dropped, 1U);
    EXPECT_EQ(models.cache_counts().built, 1U + 3);  // floor, three heights
    models.pose(frame_of(2));
    EXPECT_EQ(models.cache_counts().built, 1U + 4);
}

}  // namespace
}  // namespace ink::methods
