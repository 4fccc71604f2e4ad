#include "harness/cells/frame_counts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "catalogue/shapes.h"
#include "tests/scene/small_meshes.h"

namespace ink::harness {
namespace {

/// 200 x 100 px; at z = -1 the image is 2 wide and 1 high.
scene::View simple_view() {
    scene::View view{{}, 200, 100};
    view.camera.eye_world = {0, 0, 0};
    view.camera.fov_y_rad = 2 * std::atan(0.5);
    return view;
}

scene::Scene sheet_scene(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
    return scene::scene_of(catalogue::make_sheet(corner, u, v));
}

TEST(CountFrame, AddsUpTheAreaOfEveryTriangle) {
    scene::Scene scene = sheet_scene({-1, -0.5, -1}, {1, 0, 0}, {0, 1, 0});
    const FrameCounts left_half = count_frame(scene, simple_view());
    EXPECT_EQ(left_half.vertices, 4);
    EXPECT_EQ(left_half.triangles, 2);
    EXPECT_EQ(left_half.frame_px, 20000);
    EXPECT_NEAR(left_half.covered_px, 10000, 1e-6);
    scene.instances.push_back({});
    const FrameCounts twice = count_frame(scene, simple_view());
    EXPECT_EQ(twice.vertices, 8);
    EXPECT_EQ(twice.triangles, 4);
    EXPECT_NEAR(twice.covered_px, 20000, 1e-6) << "hidden ones too, and from both sides";
}

TEST(CountFrame, CutsAtTheFrame) {
    const scene::Scene wall = sheet_scene({-50, -50, -1}, {100, 0, 0}, {0, 100, 0});
    EXPECT_NEAR(count_frame(wall, simple_view()).covered_px, 20000, 1e-6);
    const scene::Scene aside = sheet_scene({5, -0.5, -1}, {1, 0, 0}, {0, 1, 0});
    EXPECT_EQ(count_frame(aside, simple_view()).covered_px, 0);
    EXPECT_EQ(count_frame(aside, simple_view()).triangles, 2) << "they are set up all the same";
}

TEST(CountFrame, CutsAtTheNearPlane) {
    const scene::Scene behind = sheet_scene({-1, -0.5, 1}, {1, 0, 0}, {0, 1, 0});
    EXPECT_EQ(count_frame(behind, simple_view()).covered_px, 0);
    // A floor from behind the eye to the horizon: the lower half of the image.
    const scene::Scene floor = sheet_scene({-1e7, -0.1, 10}, {2e7, 0, 0}, {0, 0, -1e7});
    EXPECT_NEAR(count_frame(floor, simple_view()).covered_px, 10000, 0.1);
}

TEST(CountFrame, OfNothingIsNothingButTheFrame) {
    const FrameCounts counts = count_frame({}, simple_view());
    EXPECT_EQ(counts.triangles, 0);
    EXPECT_EQ(counts.covered_px, 0);
    EXPECT_EQ(counts.frame_px, 20000);
}

}  // namespace
}  // namespace ink::harness
