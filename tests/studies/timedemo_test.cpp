#include "studies/timedemo.h"
#include "methods/method_configs.h"

#include <gmock/gmock.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <numeric>
#include <set>

#include "core/error.h"
#include "scene/animation.h"
#include "tests/core/error_text.h"

namespace ink::studies {
namespace {

using testing::HasSubstr;

TEST(MedianRange, IsMadeOfOrderStatistics) {
    std::vector<std::int64_t> values(100);
    std::iota(values.rbegin(), values.rend(), 1);
    // Ranks 41 and 60 hold the median of 100 with 95 %, as tables have it.
    const MedianRange of_100 = median_range(values);
    EXPECT_EQ(of_100.median, 50);
    EXPECT_EQ(of_100.low, 41);
    EXPECT_EQ(of_100.high, 60);
    const MedianRange of_one = median_range({7});
    EXPECT_EQ(of_one.median, 7);
    EXPECT_EQ(of_one.low, 7);
    EXPECT_EQ(of_one.high, 7);
}

TEST(TimedemoTable, AddsUpWhatAFrameTakes) {
    DemoFrame frame;
    frame.path = "orbit";
    frame.method = "mote4";
    frame.fill_ns = 1'000'000;
    frame.shade_ns = 4'000'000;
    frame.pose_ns = 4'000'000;
    frame.draw_ns = 1'000'000;
    frame.compose_ns = 1'000'000;
    frame.toon_ns = 3'000'000;
    DemoFrame cached = frame;
    cached.pass = 1;
    cached.pose_ns = 1'000'000;
    const std::string table = timedemo_table({frame, cached});
    EXPECT_THAT(table, HasSubstr("1000 [1000, 1000]")) << "plain: 1 ms";
    EXPECT_THAT(table, HasSubstr("250 [250, 250]")) << "shading: 4 ms";
    EXPECT_THAT(table, HasSubstr("125 [125, 125]")) << "no edges, first: 8 ms";
    EXPECT_THAT(table, HasSubstr("100 [100, 100]")) << "full, first: 10 ms";
    EXPECT_THAT(table, HasSubstr("200 [200, 200]")) << "no edges, cached: 5 ms";
    EXPECT_THAT(table, HasSubstr("143 [143, 143]")) << "full, cached: 7 ms";
    EXPECT_THAT(table, HasSubstr("111 [111, 111]")) << "toon, first: 9 ms";
    EXPECT_THAT(table, HasSubstr("167 [167, 167]")) << "toon, cached: 6 ms";
    EXPECT_EQ(timedemo_table({}), "");
}

TEST(Timedemo, DrawsEveryFrameOfEveryPassAlongThreePaths) {
    harness::ViewRequest request;
    request.width_px = 96;
    request.height_px = 64;
    const harness::SceneViews gear =
        harness::make_scene_views(harness::load_scene("gear"), request);
    TimedemoOptions options;
    options.configs = methods::make_configs("mote4,strokes", {});
    options.frames = 3;
    options.cached_passes = 1;
    const auto frames = run_timedemo(gear, options);
    EXPECT_EQ(frames.size(), 3U * 2 * 3 * 2) << "paths, passes, frames, methods";
    std::set<std::string> paths;
    std::set<std::string> images;
    for (const DemoFrame& frame : frames) {
        paths.insert(frame.path);
        if (frame.method == "mote4" && frame.path == "orbit") images.insert(frame.image_hash);
        EXPECT_EQ(frame.time_s, 4.0 * frame.frame / 3);
        for (const std::int64_t ns :
             {frame.fill_ns, frame.shade_ns, frame.toon_ns, frame.draw_ns, frame.compose_ns}) {
            EXPECT_GT(ns, 0);
        }
    }
    EXPECT_EQ(paths, (std::set<std::string>{"orbit", "dolly", "shake"}));
    EXPECT_EQ(images.size(), 3U) << "it moves, and comes out the same again";
    EXPECT_THAT(timedemo_heading(gear, options), HasSubstr("gear, 4 s of keys, 3 drawn"));
}

TEST(Timedemo, SaysWhoseLightsItDrawsUnder) {
    harness::ViewRequest request;
    request.width_px = 64;
    request.height_px = 48;
    harness::SceneViews gear = harness::make_scene_views(harness::load_scene("gear"), request);
    EXPECT_THAT(timedemo_heading(gear, {}), HasSubstr(", own lights;"));
    gear.scene.lights.clear();
    EXPECT_THAT(timedemo_heading(gear, {}), HasSubstr(", studio lights;"));
}

TEST(Timedemo, AnEyeInsideLooksAbout) {
    harness::ViewRequest request;
    request.width_px = 64;
    request.height_px = 48;
    request.cameras.push_back({{0, 0, 0.01}, glm::dvec3(1, 0, 0)});
    TimedemoOptions options;
    options.configs = methods::make_configs("mote4", {});
    options.frames = 2;
    options.cached_passes = 0;
    std::set<std::string> paths;
    for (const DemoFrame& frame :
         run_timedemo(harness::make_scene_views(harness::load_scene("gear"), request), options))
        paths.insert(frame.path);
    EXPECT_EQ(paths, (std::set<std::string>{"pan", "roll", "shake"}));
}

/// The gears as a file would hold them, with a camera that turns with the wheel.
scene::Scene filmed_gear() {
    scene::Scene scene = harness::load_scene("gear");
    scene.name = "film";
    scene.cameras.resize(1);
    scene.cameras[0] = scene::look_at({0, 0, 9}, {0, 0, 0}, {0, 1, 0}, 0.6);
    scene.cameras[0].name = "rider";
    scene::Animation animation = *scene.animation;
    scene::AnimatedNode rider;
    rider.parent = 1;  // the wheel
    rider.parent_from_node =
        glm::inverse(glm::lookAt(glm::dvec3(3, 8, 0), glm::dvec3(0), glm::dvec3(1, 0, 0)));
    animation.node_of_camera = {static_cast<std::uint32_t>(animation.nodes.size())};
    animation.nodes.push_back(rider);
    scene.animation = std::make_shared<const scene::Animation>(animation);
    return scene;
}

TEST(Timedemo, AMovingCameraOfTheModelGoesItsOwnWayFirst) {
    harness::ViewRequest request;
    request.width_px = 64;
    request.height_px = 48;
    request.file_cameras = true;
    TimedemoOptions options;
    options.configs = methods::make_configs("mote4", {});
    options.frames = 3;
    options.cached_passes = 1;
    std::vector<std::string> paths;
    std::set<std::string> images;
    for (const DemoFrame& frame :
         run_timedemo(harness::make_scene_views(filmed_gear(), request), options)) {
        if (paths.empty() || paths.back() != frame.path) paths.push_back(frame.path);
        if (frame.path == "own") images.insert(frame.image_hash);
    }
    EXPECT_EQ(paths, (std::vector<std::string>{"own", "orbit", "dolly", "shake"}));
    EXPECT_EQ(images.size(), 3U);
    request.file_cameras = false;
    paths.clear();
    for (const DemoFrame& frame :
         run_timedemo(harness::make_scene_views(filmed_gear(), request), options)) {
        if (paths.empty() || paths.back() != frame.path) paths.push_back(frame.path);
    }
    EXPECT_EQ(paths, (std::vector<std::string>{"orbit", "dolly", "shake"}));
}

TEST(PosedSceneViews, ItsFileCamerasStandWhereTheyAreAtThatMoment) {
    harness::ViewRequest request;
    request.file_cameras = true;
    request.time_s = 2;
    const harness::SceneViews posed = harness::make_scene_views(filmed_gear(), request);
    ASSERT_EQ(posed.views.size(), 1U);
    const scene::Camera& camera = posed.views[0].camera;
    EXPECT_EQ(camera.name, "rider");
    scene::Camera expected = posed.scene.cameras[0];
    EXPECT_EQ(camera.eye_world, expected.eye_world);
    EXPECT_NE(camera.eye_world, filmed_gear().cameras[0].eye_world);
    scene::fit_clip_range(expected, scene::bounding_sphere(posed.scene));
    EXPECT_EQ(camera.near, expected.near);
    EXPECT_EQ(camera.far, expected.far);
}

/// What make_scene_views says of a request for `scene`.
std::string complaint(const std::string& scene, const harness::ViewRequest& request) {
    return core::error_text(
        [&] { return harness::make_scene_views(harness::load_scene(scene), request); });
}

TEST(PosedSceneViews, IsCalledAndHashedAsItIsPosed) {
    harness::ViewRequest request;
    request.time_s = 1.5;
    const harness::SceneViews posed =
        harness::make_scene_views(harness::load_scene("gear"), request);
    EXPECT_EQ(posed.scene.name, "gear.1.5s");
    EXPECT_EQ(posed.views.size(), posed.scene.cameras.size()) << "the catalogue's own views";
    EXPECT_NE(scene::scene_hash(posed.scene), scene::scene_hash(harness::load_scene("gear")));
}

TEST(PosedSceneViews, OnlyAtMomentsThatThereAre) {
    harness::ViewRequest late;
    late.time_s = 4.5;
    EXPECT_EQ(complaint("gear", late), "--time: gear does not move at 4.5 s (accepted: 0..4)");
    EXPECT_THAT(complaint("cube", late), HasSubstr("--time: cube does not move (accepted: "));
    harness::ViewRequest frame;
    frame.frame = 3;
    EXPECT_EQ(complaint("gear", frame),
              "--frame: gear stores no frames (accepted: --time SECONDS)");
}

}  // namespace
}  // namespace ink::studies
