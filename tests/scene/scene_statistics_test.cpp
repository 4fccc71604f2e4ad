#include "scene/scene_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "catalogue/shapes.h"
#include "tests/scene/small_meshes.h"

namespace ink::scene {
namespace {

constexpr double kCrease_rad = 40 * std::numbers::pi / 180;
constexpr double kRightAngle_rad = std::numbers::pi / 2;

SceneStatistics statistics_of(const Scene& scene) {
    return make_scene_statistics(scene, kCrease_rad);
}

TEST(SceneStatistics, OfACubeHasTwelveCreasesAndSixFlatDiagonals) {
    const SceneStatistics statistics = statistics_of(scene_of(unit_cube()));
    EXPECT_EQ(statistics.triangles, 12U);
    EXPECT_EQ(statistics.vertices, 8U);
    EXPECT_EQ(statistics.objects, 1U);
    EXPECT_EQ(statistics.materials, 1U);
    EXPECT_EQ(statistics.creases.count, 12U);
    EXPECT_DOUBLE_EQ(statistics.creases.length_world, 12 * 2);
    EXPECT_EQ(statistics.flat.count, 6U);
    EXPECT_DOUBLE_EQ(statistics.flat.length_world, 6 * 2 * std::numbers::sqrt2);
    EXPECT_EQ(statistics.smooth.count, 0U);
    EXPECT_FALSE(statistics.is_curved());
    EXPECT_DOUBLE_EQ(statistics.least_crease_rad, kRightAngle_rad);
    EXPECT_EQ(statistics.deviations[9], 12U);
    EXPECT_EQ(statistics.components, 1U);
    EXPECT_EQ(statistics.convex_components, 1U);
    EXPECT_TRUE(statistics.is_watertight());
    EXPECT_FALSE(statistics.may_hide());
    EXPECT_FALSE(statistics.may_cross());
    EXPECT_EQ(statistics.extent_ratio, 1);
}

TEST(SceneStatistics, ThinIsWhatHasLittleAreaForItsLines) {
    Scene scene = scene_of({unit_cube(), unit_cube()});
    EXPECT_EQ(statistics_of(scene).thin_share, 0);
    // As long as the cube, and a thousandth as wide: half of all lines but eight short ones.
    scene.instances[1].world_from_object =
        glm::scale(glm::translate(glm::dmat4(1), {3, 0, 0}), {1e-3, 1, 1e-3});
    EXPECT_NEAR(statistics_of(scene).thin_share, 8.0 / (8 + 24), 1e-3);
    EXPECT_EQ(statistics_of(scene).smooth_share(), 0);
}

TEST(SceneStatistics, OfACubeInsideOutIsClosedButNotWatertight) {
    Mesh mesh = unit_cube();
    for (Triangle& t : mesh.triangles)
        std::swap(t[0], t[1]);
    const SceneStatistics statistics = statistics_of(scene_of(mesh));
    EXPECT_EQ(statistics.watertight_components, 0U);
    EXPECT_EQ(statistics.convex_components, 0U);
    EXPECT_EQ(statistics.boundary.count, 0U);
}

TEST(SceneStatistics, OfASphereIsCurvedConvexAndWithoutCreases) {
    const SceneStatistics statistics = statistics_of(scene_of(catalogue::make_icosphere(1, 3)));
    EXPECT_EQ(statistics.triangles, 20U * 64);
    EXPECT_EQ(statistics.smooth.count, 30U * 64);
    EXPECT_FALSE(statistics.has_creases());
    EXPECT_TRUE(statistics.is_curved());
    EXPECT_EQ(statistics.convex_components, 1U);
    EXPECT_FALSE(statistics.may_hide());
    EXPECT_EQ(statistics.least_crease_rad, 0);
}

TEST(SceneStatistics, OfATorusIsWatertightButHidesItself) {
    const SceneStatistics statistics =
        statistics_of(scene_of(catalogue::make_torus({2, 0.5}, {48, 24})));
    EXPECT_EQ(statistics.watertight_components, 1U);
    EXPECT_EQ(statistics.convex_components, 0U);
    EXPECT_TRUE(statistics.may_hide());
    EXPECT_FALSE(statistics.has_creases());
    // Round the tube, each of the 24 turns bends by 15 degrees; along the ring by less.
    EXPECT_NEAR(statistics.largest_smooth_rad, 2 * std::numbers::pi / 24, 1e-3);
}

TEST(SceneStatistics, OfAQuadIsOpenAndFlat) {
    const SceneStatistics statistics =
        statistics_of(scene_of(catalogue::make_sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0})));
    EXPECT_EQ(statistics.boundary.count, 4U);
    EXPECT_DOUBLE_EQ(statistics.boundary.length_world, 4);
    EXPECT_EQ(statistics.flat.count, 1U);
    EXPECT_EQ(statistics.seams.count, 0U);
    EXPECT_EQ(statistics.watertight_components, 0U);
    EXPECT_EQ(statistics.loose_triangles, 0U);
    EXPECT_EQ(statistics.cracked_corners, 0U);
    EXPECT_TRUE(statistics.may_hide()) << "an open component is not known to be convex";
}

TEST(SceneStatistics, OfTwoCoplanarTilesHasOneSeam) {
    const SceneStatistics statistics =
        statistics_of(scene_of({catalogue::make_sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                                catalogue::make_sheet({1, 0, 0}, {2, 0, 0}, {0, 1, 0})}));
    EXPECT_EQ(statistics.seams.count, 1U);
    EXPECT_DOUBLE_EQ(statistics.seams.length_world, 1);
    EXPECT_EQ(statistics.boundary.count, 6U);
    EXPECT_EQ(statistics.components, 1U);
    EXPECT_DOUBLE_EQ(statistics.extent_ratio, std::sqrt(5.0 / 2));
    EXPECT_EQ(statistics.near_sheets.pairs, 0U);
}

TEST(SceneStatistics, OfBoxesThroughEachOtherMayCross) {
    const SceneStatistics through = statistics_of(scene_of(
        {catalogue::make_box({-1, -1, -1}, {1, 1, 1}), catalogue::make_box({0, 0, 0}, {2, 2, 2})}));
    EXPECT_EQ(through.components, 2U);
    EXPECT_EQ(through.overlapping_components, 1U);
    const SceneStatistics apart = statistics_of(scene_of(
        {catalogue::make_box({-1, -1, -1}, {1, 1, 1}), catalogue::make_box({1, 2, 3}, {2, 3, 4})}));
    EXPECT_EQ(apart.overlapping_components, 0U);
    EXPECT_TRUE(apart.may_hide());
}

TEST(SceneStatistics, OfBoxesThatTouchDoesNotCross) {
    // Not in a common corner, which would weld them into one component.
    const SceneStatistics statistics =
        statistics_of(scene_of({catalogue::make_box({-1, -1, -1}, {1, 1, 1}),
                                catalogue::make_box({1, -0.5, -0.5}, {2, 0.5, 0.5})}));
    EXPECT_EQ(statistics.overlapping_components, 0U);
}

TEST(SceneStatistics, AFlatSheetThroughABoxMayCrossIt) {
    const SceneStatistics statistics = statistics_of(
        scene_of({unit_cube(), catalogue::make_sheet({-2, 0, -2}, {0, 0, 4}, {4, 0, 0})}));
    EXPECT_EQ(statistics.overlapping_components, 1U);
}

TEST(SceneStatistics, BallsWhoseBoxesOverlapAtACornerOnlyDoNotCross) {
    Scene scene = scene_of({catalogue::make_icosphere(1, 2), catalogue::make_icosphere(1, 2)});
    scene.instances[1].world_from_object = glm::translate(glm::dmat4(1), {1.5, 1.5, 1.5});
    EXPECT_EQ(statistics_of(scene).overlapping_components, 0U);
}

TEST(SceneStatistics, CountsLooseTrianglesAndCracks) {
    // Two triangles that should share an edge, a hair apart.
    Mesh mesh;
    mesh.positions = {
        {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 1.00001F, 0}, {1.00001F, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    const SceneStatistics statistics = statistics_of(scene_of(mesh));
    EXPECT_EQ(statistics.loose_triangles, 2U);
    EXPECT_EQ(statistics.loose_share(), 1);
    EXPECT_EQ(statistics.cracked_corners, 4U);
    EXPECT_EQ(statistics.components, 2U);
}

TEST(SceneStatistics, CountsAFinAsNonManifoldAndACrease) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    const SceneStatistics statistics = statistics_of(scene_of(mesh));
    EXPECT_EQ(statistics.nonmanifold.count, 1U);
    EXPECT_TRUE(statistics.has_creases());
    EXPECT_EQ(statistics.boundary.count, 6U);
}

TEST(SceneStatistics, CountsSmoothEdgesThatRunTheSameWay) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0.2F}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
    EXPECT_EQ(statistics_of(scene_of(mesh)).inside_out.count, 1U);
}

TEST(SceneStatistics, MeasuresTheGapOfParallelSheets) {
    const Mesh low = catalogue::make_sheet({-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
    const Mesh high = catalogue::make_sheet({-1, 0.0078125, -1}, {0, 0, 2}, {2, 0, 0});
    const SceneStatistics statistics = statistics_of(scene_of({low, high}));
    EXPECT_GT(statistics.near_sheets.pairs, 0U);
    EXPECT_NEAR(statistics.near_sheets.least_gap_share, 0.0078125 / std::sqrt(2.0), 1e-5);
    EXPECT_EQ(statistics_of(scene_of(low)).near_sheets.pairs, 0U);
}

TEST(SceneStatistics, OfAnEmptySceneIsZeros) {
    const SceneStatistics statistics = statistics_of({});
    EXPECT_EQ(statistics.triangles, 0U);
    EXPECT_EQ(statistics.components, 0U);
    EXPECT_FALSE(statistics.is_watertight());
    EXPECT_FALSE(statistics.may_hide());
}

TEST(SceneStatistics, TheOrderOfObjectsDoesNotMatter) {
    const std::vector<Mesh> meshes = {catalogue::make_box({0, 0, 0}, {1, 2, 3}),
                                      catalogue::make_icosphere(1, 2)};
    const SceneStatistics one = statistics_of(scene_of(meshes));
    const SceneStatistics other = statistics_of(scene_of({meshes[1], meshes[0]}));
    EXPECT_EQ(one.creases.count, other.creases.count);
    EXPECT_EQ(one.smooth.count, other.smooth.count);
    EXPECT_EQ(one.deviations, other.deviations);
    EXPECT_EQ(one.convex_components, other.convex_components);
    EXPECT_EQ(one.overlapping_components, other.overlapping_components);
}

}  // namespace
}  // namespace ink::scene
