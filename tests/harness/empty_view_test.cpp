#include "harness/truths/unscored_view.h"

#include <gmock/gmock.h>

#include "tests/harness/baselines.h"
#include "tests/scene/small_meshes.h"

namespace ink::harness {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// The baselines of a scene from an eye that looks along `direction`, scored in full or briefly.
std::vector<Row> rows_of(const scene::Scene& scene,
                         const glm::dvec3& eye_world,
                         std::pair<int, int> size_px,
                         bool is_full = true) {
    ViewRequest request;
    request.width_px = size_px.first;
    request.height_px = size_px.second;
    CameraRequest camera;
    camera.eye_world = eye_world;
    camera.target_world = glm::dvec3(0);
    if (glm::length(eye_world) > 10) camera.target_world = 2.0 * eye_world;  // away from it
    request.cameras = {camera};
    const std::vector<Evaluation> evaluations =
        baselines_of(make_scene_views(scene, request), {}, is_full);
    std::vector<std::string> faults;
    check_baselines(evaluations, faults);
    EXPECT_THAT(faults, testing::IsEmpty()) << "a view without truth makes no run void";
    std::vector<Row> rows;
    for (const Evaluation& evaluation : evaluations)
        rows.push_back(evaluation.row);
    EXPECT_EQ(rows.size(), 4U);
    return rows;
}

/// Every row says why, and holds no number that a score says.
void expect_empty(const std::vector<Row>& rows, const std::string& why) {
    for (Row row : rows) {
        EXPECT_THAT(row.status, AllOf(StartsWith("empty: "), HasSubstr(why))) << row.method;
        EXPECT_FALSE(row.is_scored());
        EXPECT_FALSE(row.f_2px || row.f_1px || row.precision_2px || row.recall_2px || row.ap);
        EXPECT_FALSE(row.above_crease_2px || row.all_intersections_2px || row.with_crowded_2px);
        EXPECT_FALSE(row.random_baseline || row.k_1px || !row.bins.empty());
        EXPECT_EQ(row.n_pred + row.n_truth + row.false_positives, 0);
    }
}

TEST(EmptyView, NothingBeforeTheCamera) {
    const scene::Scene scene = scene::scene_of(scene::unit_cube());
    expect_empty(rows_of(scene, {0, 0, 20}, {64, 36}), "no line of the scene is in the image");
    expect_empty(rows_of(scene, {0, 0, 20}, {64, 36}, false), "no line of the scene");
}

TEST(EmptyView, NoTriangleHasAnArea) {
    scene::Scene scene = scene::scene_of(scene::unit_cube());
    for (glm::vec3& p : scene.meshes[0].positions)
        p.y = p.z = 0;
    expect_empty(rows_of(scene, {3, 2, 5}, {64, 36}), "no triangle has an area");
}

TEST(EmptyView, TheBandLeavesNothing) {
    const scene::Scene scene = scene::scene_of(scene::unit_cube());
    expect_empty(rows_of(scene, {2, 1.5, 3}, {13, 13}), "px of the frame");
    expect_empty(rows_of(scene, {2, 1.5, 3}, {1, 400}), "");
}

TEST(EmptyView, OneTruePixelIsEnough) {
    for (const Row& row : rows_of(scene::scene_of(scene::unit_cube()), {2, 1.5, 3}, {64, 36})) {
        EXPECT_EQ(row.status, "ok");
        EXPECT_GT(row.n_truth, 0);
        EXPECT_TRUE(row.is_scored());
    }
}

}  // namespace
}  // namespace ink::harness
