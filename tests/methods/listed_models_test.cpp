#include "methods/edge_list/listed_models.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>

#include "catalogue/shapes.h"
#include "core/error.h"
#include "tests/core/error_text.h"
#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

constexpr double kCrease_rad = 0.7;

/// Contours, creases, edges of a boundary.
using KindCounts = std::array<std::ptrdiff_t, 3>;

KindCounts count(const std::vector<buffers::KnownEdge>& edges) {
    const auto of = [&](buffers::EdgeKind kind) {
        return std::count_if(
            edges.begin(), edges.end(), [&](const auto& edge) { return edge.kind == kind; });
    };
    return {of(buffers::EdgeKind::contour),
            of(buffers::EdgeKind::crease),
            of(buffers::EdgeKind::boundary)};
}

ListedModels posed(const scene::Scene& scene, EdgeScope scope = EdgeScope::object) {
    ListedModels models(scope, EdgeBuilder::temp_list, kCrease_rad);
    models.prepare(scene);
    models.pose(scene);
    return models;
}

scene::Camera camera(const glm::dvec3& eye, const glm::dvec3& target) {
    return scene::look_at(eye, target, {0, 1, 0}, 0.7);
}

KindCounts seen_from(const ListedModels& models,
                     const scene::Camera& camera,
                     FacingRule facing = FacingRule::position,
                     EdgeOnRule edge_on = EdgeOnRule::include) {
    return count(models.lines(camera, facing, edge_on));
}

TEST(ListedModels, ACubeHasTwelveLinesFromEverySide) {
    const ListedModels models = posed(scene_of({cube_mesh()}));
    // Three faces seen: six edges round them; three between them and three between the others.
    EXPECT_EQ(seen_from(models, camera({4, 3, 5}, {0, 0, 0})), (KindCounts{6, 6, 0}));
    EXPECT_EQ(seen_from(models, camera({4, 0, 5}, {0, 0, 0})), (KindCounts{6, 6, 0}));
    EXPECT_EQ(seen_from(models, camera({0, 0, 5}, {0, 0, 0})), (KindCounts{4, 8, 0}));
    EXPECT_EQ(seen_from(models, camera({0, 0, 0.5}, {0, 0, 0})), (KindCounts{0, 12, 0}));
}

TEST(ListedModels, TheViewDirectionTurnsFacesThatTheEyesPositionDoesNot) {
    scene::Scene scene = scene_of({cube_mesh()});
    scene.instances[0].world_from_object = glm::translate(glm::dmat4(1), {3, 0, 0});
    const ListedModels models = posed(scene);
    // The eye stands in front of x = 2 and z = 1. A view direction towards -x sees x = 2 from
    // behind.
    const glm::dvec3 eye(0, 0, 5);
    const scene::Camera away = camera(eye, eye + glm::dvec3(-0.25, 0, -1));
    EXPECT_EQ(seen_from(models, away), (KindCounts{6, 6, 0}));
    const auto edge_between = [&](FacingRule facing) {
        for (const buffers::KnownEdge& edge : models.lines(away, facing, EdgeOnRule::include)) {
            if (edge.a_world + edge.b_world == glm::dvec3(4, 0, 2)) return edge.kind;
        }
        return buffers::EdgeKind::none;
    };
    EXPECT_EQ(edge_between(FacingRule::position), buffers::EdgeKind::crease);
    EXPECT_EQ(edge_between(FacingRule::direction), buffers::EdgeKind::contour);
}

TEST(ListedModels, AnEdgeOnFaceIsAContoursOtherSideByOption) {
    const ListedModels models = posed(scene_of({cube_mesh()}));
    const scene::Camera in_plane = camera({1, 0, 5}, {1, 0, 0});  // of x = 1, which is edge-on
    EXPECT_EQ(seen_from(models, in_plane), (KindCounts{3 + 4, 5, 0}));
    EXPECT_EQ(seen_from(models, in_plane, FacingRule::position, EdgeOnRule::leave_out),
              (KindCounts{3, 9, 0}));
}

TEST(ListedModels, AFaceAloneHasThreeBoundaryEdges) {
    scene::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    EXPECT_EQ(seen_from(posed(scene_of({mesh})), camera({0, 0, 3}, {0, 0, 0})),
              (KindCounts{0, 0, 3}));
}

TEST(ListedModels, TilesThatTouchHaveEdgesOfTheirOwnUnlessTheSceneIsOneList) {
    scene::Scene scene = scene_of({floor_mesh(1), floor_mesh(1)});
    scene.instances[1].world_from_object = glm::translate(glm::dmat4(1), {2, 0, 0});
    const scene::Camera above = camera({1, 5, 0.5}, {1, 0, 0});
    EXPECT_EQ(seen_from(posed(scene), above), (KindCounts{0, 0, 8}));
    ListedModels models = posed(scene, EdgeScope::scene);
    EXPECT_EQ(seen_from(models, above), (KindCounts{0, 0, 6}));
    scene.instances[1].world_from_object = glm::translate(glm::dmat4(1), {2.5, 0, 0});
    models.pose(scene);
    EXPECT_EQ(seen_from(models, above), (KindCounts{0, 0, 8}));
}

TEST(ListedModels, AllPairsOfALargeMeshIsRefused) {
    ListedModels models(EdgeScope::object, EdgeBuilder::all_pairs, kCrease_rad);
    const scene::Scene scene =
        scene_of({catalogue::make_sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {200, 200})});
    EXPECT_THAT(core::error_text([&] { models.prepare(scene); }),
                testing::ContainsRegex("^edge_list: .*80000 triangles.*temp_list . hash"));
}

}  // namespace
}  // namespace ink::methods
