#include "scene/ledger.h"

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

Ledger ledger_of(const Scene& scene) {
    return make_ledger(scene, kCrease_rad);
}

/// Each mesh an object of its own, where it is.
Scene scene_of(std::vector<Mesh> meshes) {
    Scene scene;
    scene.name = "test";
    for (std::uint32_t i = 0; i < meshes.size(); ++i)
        scene.instances.push_back({i, glm::dmat4(1), "part"});
    scene.meshes = std::move(meshes);
    return scene;
}

TEST(Ledger, OfACubeHasTwelveCreasesAndSixFlatDiagonals) {
    const Ledger ledger = ledger_of(scene_of(unit_cube()));
    EXPECT_EQ(ledger.triangles, 12U);
    EXPECT_EQ(ledger.vertices, 8U);
    EXPECT_EQ(ledger.objects, 1U);
    EXPECT_EQ(ledger.materials, 1U);
    EXPECT_EQ(ledger.creases.count, 12U);
    EXPECT_DOUBLE_EQ(ledger.creases.length_world, 12 * 2);
    EXPECT_EQ(ledger.flat.count, 6U);
    EXPECT_DOUBLE_EQ(ledger.flat.length_world, 6 * 2 * std::numbers::sqrt2);
    EXPECT_EQ(ledger.smooth.count, 0U);
    EXPECT_FALSE(ledger.is_curved());
    EXPECT_DOUBLE_EQ(ledger.least_crease_rad, kRightAngle_rad);
    EXPECT_EQ(ledger.bends[9], 12U);
    EXPECT_EQ(ledger.pieces, 1U);
    EXPECT_EQ(ledger.convex_pieces, 1U);
    EXPECT_TRUE(ledger.is_sealed());
    EXPECT_FALSE(ledger.may_hide());
    EXPECT_FALSE(ledger.may_cross());
    EXPECT_EQ(ledger.extent_ratio, 1);
}

TEST(Ledger, OfACubeInsideOutIsClosedButNotSealed) {
    Mesh mesh = unit_cube();
    for (Triangle& t : mesh.triangles)
        std::swap(t[0], t[1]);
    const Ledger ledger = ledger_of(scene_of(mesh));
    EXPECT_EQ(ledger.sealed_pieces, 0U);
    EXPECT_EQ(ledger.convex_pieces, 0U);
    EXPECT_EQ(ledger.boundary.count, 0U);
}

TEST(Ledger, OfASphereIsCurvedConvexAndWithoutCreases) {
    const Ledger ledger = ledger_of(scene_of(catalogue::make_icosphere(1, 3)));
    EXPECT_EQ(ledger.triangles, 20U * 64);
    EXPECT_EQ(ledger.smooth.count, 30U * 64);
    EXPECT_FALSE(ledger.has_creases());
    EXPECT_TRUE(ledger.is_curved());
    EXPECT_EQ(ledger.convex_pieces, 1U);
    EXPECT_FALSE(ledger.may_hide());
    EXPECT_EQ(ledger.least_crease_rad, 0);
}

TEST(Ledger, OfATorusIsSealedButHidesItself) {
    const Ledger ledger = ledger_of(scene_of(catalogue::make_torus({2, 0.5}, {48, 24})));
    EXPECT_EQ(ledger.sealed_pieces, 1U);
    EXPECT_EQ(ledger.convex_pieces, 0U);
    EXPECT_TRUE(ledger.may_hide());
    EXPECT_FALSE(ledger.has_creases());
    // Round the tube, each of the 24 turns bends by 15 degrees; along the ring by less.
    EXPECT_NEAR(ledger.largest_smooth_rad, 2 * std::numbers::pi / 24, 1e-3);
}

TEST(Ledger, OfAQuadIsOpenAndFlat) {
    const Ledger ledger =
        ledger_of(scene_of(catalogue::make_sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0})));
    EXPECT_EQ(ledger.boundary.count, 4U);
    EXPECT_DOUBLE_EQ(ledger.boundary.length_world, 4);
    EXPECT_EQ(ledger.flat.count, 1U);
    EXPECT_EQ(ledger.seams.count, 0U);
    EXPECT_EQ(ledger.sealed_pieces, 0U);
    EXPECT_EQ(ledger.loose_triangles, 0U);
    EXPECT_EQ(ledger.cracked_corners, 0U);
    EXPECT_TRUE(ledger.may_hide()) << "an open piece is not known to be convex";
}

TEST(Ledger, OfTwoCoplanarTilesHasOneSeam) {
    const Ledger ledger =
        ledger_of(scene_of({catalogue::make_sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                            catalogue::make_sheet({1, 0, 0}, {2, 0, 0}, {0, 1, 0})}));
    EXPECT_EQ(ledger.seams.count, 1U);
    EXPECT_DOUBLE_EQ(ledger.seams.length_world, 1);
    EXPECT_EQ(ledger.boundary.count, 6U);
    EXPECT_EQ(ledger.pieces, 1U);
    EXPECT_DOUBLE_EQ(ledger.extent_ratio, std::sqrt(5.0 / 2));
    EXPECT_EQ(ledger.near_sheets.pairs, 0U);
}

TEST(Ledger, OfAStaircaseBendsBothWays) {
    const std::vector<glm::dvec2> profile = {
        {0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 3}, {0, 3}};
    const Ledger ledger = ledger_of(scene_of(catalogue::extrude(profile, {0, 1})));
    EXPECT_EQ(ledger.creases.count, 3U * 8);
    EXPECT_EQ(ledger.sealed_pieces, 1U);
    EXPECT_EQ(ledger.convex_pieces, 0U);
    EXPECT_TRUE(ledger.may_hide());
    EXPECT_FALSE(ledger.may_cross());
}

TEST(Ledger, OfBoxesThroughEachOtherMayCross) {
    const Ledger through = ledger_of(scene_of(
        {catalogue::make_box({-1, -1, -1}, {1, 1, 1}), catalogue::make_box({0, 0, 0}, {2, 2, 2})}));
    EXPECT_EQ(through.pieces, 2U);
    EXPECT_EQ(through.overlapping_pieces, 1U);
    const Ledger apart = ledger_of(scene_of(
        {catalogue::make_box({-1, -1, -1}, {1, 1, 1}), catalogue::make_box({1, 2, 3}, {2, 3, 4})}));
    EXPECT_EQ(apart.overlapping_pieces, 0U);
    EXPECT_TRUE(apart.may_hide());
}

TEST(Ledger, OfBoxesThatTouchDoesNotCross) {
    // Not in a common corner, which would weld them into one piece.
    const Ledger ledger =
        ledger_of(scene_of({catalogue::make_box({-1, -1, -1}, {1, 1, 1}),
                            catalogue::make_box({1, -0.5, -0.5}, {2, 0.5, 0.5})}));
    EXPECT_EQ(ledger.overlapping_pieces, 0U);
}

TEST(Ledger, AFlatSheetThroughABoxMayCrossIt) {
    const Ledger ledger = ledger_of(
        scene_of({unit_cube(), catalogue::make_sheet({-2, 0, -2}, {0, 0, 4}, {4, 0, 0})}));
    EXPECT_EQ(ledger.overlapping_pieces, 1U);
}

TEST(Ledger, BallsWhoseBoxesOverlapAtACornerOnlyDoNotCross) {
    Scene scene = scene_of({catalogue::make_icosphere(1, 2), catalogue::make_icosphere(1, 2)});
    scene.instances[1].world_from_object = glm::translate(glm::dmat4(1), {1.5, 1.5, 1.5});
    EXPECT_EQ(ledger_of(scene).overlapping_pieces, 0U);
}

TEST(Ledger, CountsLooseTrianglesAndCracks) {
    // Two triangles that should share an edge, a hair apart.
    Mesh mesh;
    mesh.positions = {
        {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 1.00001F, 0}, {1.00001F, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    const Ledger ledger = ledger_of(scene_of(mesh));
    EXPECT_EQ(ledger.loose_triangles, 2U);
    EXPECT_EQ(ledger.loose_share(), 1);
    EXPECT_EQ(ledger.cracked_corners, 4U);
    EXPECT_EQ(ledger.pieces, 2U);
}

TEST(Ledger, CountsAFinAsNonManifoldAndACrease) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    const Ledger ledger = ledger_of(scene_of(mesh));
    EXPECT_EQ(ledger.nonmanifold.count, 1U);
    EXPECT_TRUE(ledger.has_creases());
    EXPECT_EQ(ledger.boundary.count, 6U);
}

TEST(Ledger, CountsSmoothEdgesThatRunTheSameWay) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0.2F}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
    EXPECT_EQ(ledger_of(scene_of(mesh)).inside_out.count, 1U);
}

TEST(Ledger, MeasuresTheGapOfParallelSheets) {
    const Mesh low = catalogue::make_sheet({-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
    const Mesh high = catalogue::make_sheet({-1, 0.0078125, -1}, {0, 0, 2}, {2, 0, 0});
    const Ledger ledger = ledger_of(scene_of({low, high}));
    EXPECT_GT(ledger.near_sheets.pairs, 0U);
    EXPECT_NEAR(ledger.near_sheets.least_gap_share, 0.0078125 / std::sqrt(2.0), 1e-5);
    EXPECT_EQ(ledger_of(scene_of(low)).near_sheets.pairs, 0U);
}

TEST(Ledger, OfAnEmptySceneIsZeros) {
    const Ledger ledger = ledger_of({});
    EXPECT_EQ(ledger.triangles, 0U);
    EXPECT_EQ(ledger.pieces, 0U);
    EXPECT_FALSE(ledger.is_sealed());
    EXPECT_FALSE(ledger.may_hide());
    EXPECT_EQ(make_view_ledger(ledger, {{}, 640, 360}).frame_share, 0);
}

TEST(Ledger, TheOrderOfObjectsDoesNotMatter) {
    const std::vector<Mesh> meshes = {catalogue::make_box({0, 0, 0}, {1, 2, 3}),
                                      catalogue::make_icosphere(1, 2)};
    const Ledger one = ledger_of(scene_of(meshes));
    const Ledger other = ledger_of(scene_of({meshes[1], meshes[0]}));
    EXPECT_EQ(one.creases.count, other.creases.count);
    EXPECT_EQ(one.smooth.count, other.smooth.count);
    EXPECT_EQ(one.bends, other.bends);
    EXPECT_EQ(one.convex_pieces, other.convex_pieces);
    EXPECT_EQ(one.overlapping_pieces, other.overlapping_pieces);
}

/// A ball of radius 1 at the origin, seen from `distance` along z.
ViewLedger ball_from(double distance) {
    Ledger ledger;
    ledger.triangles = 100;
    ledger.bounds = {{0, 0, 0}, 1};
    View view{look_at({0, 0, distance}, {0, 0, 0}, {0, 1, 0}, kRightAngle_rad), 400, 400};
    view.camera.near = 0.5;
    return make_view_ledger(ledger, view);
}

TEST(ViewLedger, KnowsHowDeepTheSceneIs) {
    EXPECT_DOUBLE_EQ(ball_from(3).near, 2);
    EXPECT_DOUBLE_EQ(ball_from(3).far, 4);
    EXPECT_DOUBLE_EQ(ball_from(3).depth_ratio(), 2);
    EXPECT_FALSE(ball_from(3).is_inside);
}

TEST(ViewLedger, AnEyeInsideSeesAllRoundFromTheNearPlaneOn) {
    const ViewLedger inside = ball_from(0.25);
    EXPECT_TRUE(inside.is_inside);
    EXPECT_DOUBLE_EQ(inside.near, 0.5);
    EXPECT_DOUBLE_EQ(inside.far, 1.25);
    EXPECT_EQ(inside.frame_share, 1);
}

TEST(ViewLedger, SharesTheFrameAsTheBallsCircleDoes) {
    // The circle's radius in a picture that is 2 wide at distance 1: tan(asin(1/3)) = 1 / sqrt(8).
    const double share = std::numbers::pi / 8 / 4;
    EXPECT_NEAR(ball_from(3).frame_share, share, 0.0025);
    EXPECT_NEAR(ball_from(3).px_per_triangle, share * 400 * 400 / 100, 4);
}

TEST(ViewLedger, ABallBehindTheEyeIsNotThere) {
    Ledger ledger;
    ledger.triangles = 1;
    ledger.bounds = {{0, 0, 10}, 1};
    const View away{look_at({0, 0, 3}, {0, 0, 0}, {0, 1, 0}, 1), 64, 64};
    EXPECT_EQ(make_view_ledger(ledger, away).frame_share, 0);
    EXPECT_EQ(make_view_ledger(ledger, away).depth_ratio(), 1);
}

}  // namespace
}  // namespace ink::scene
