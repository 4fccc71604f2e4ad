#include "scene/views/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "core/error.h"

namespace ink::scene {
namespace {

constexpr double kRightAngle_rad = std::numbers::pi / 2;
constexpr Sphere kBall{{0, 0, 0}, 2};

/// 200 x 100 px, 90 degrees high: the focal length is 50 px. The eye is 10 from the ball's middle.
View view_from(const glm::dvec3& eye_world) {
    Camera camera = look_at(eye_world, {0, 0, 0}, {0, 1, 0}, kRightAngle_rad);
    fit_clip_range(camera, kBall);
    return {camera, 200, 100};
}

glm::dvec2 on_image(const View& view, const glm::dvec3& p_world) {
    const glm::dvec3 p_clip = Projection(view).to_clip(p_world);
    return {p_clip.x / p_clip.z, p_clip.y / p_clip.z};
}

View view_at(const CameraPath& path, int frame) {
    return frame_at(path, frame).view;
}

TEST(CameraPath, StillKeepsTheViewAndCountsTheTime) {
    const CameraPath path = make_path(PathKind::still, view_from({0, 0, 10}), kBall, 0.5);
    const PathFrame frame = frame_at(path, 30);
    EXPECT_EQ(frame.time_s, 0.5);
    EXPECT_EQ(frame.view.camera.eye_world, glm::dvec3(0, 0, 10));
    EXPECT_EQ(frame.view.camera.view_from_world, path.start.camera.view_from_world);
    EXPECT_EQ(frame.view.width_px, 200);
    EXPECT_EQ(frame.view.camera.name, "still_030");
}

TEST(CameraPath, OrbitCarriesTheNearestPointByItsStep) {
    // Seen from 53 degrees up: the nearest point is (0, 1.6, 1.2), 8 from the eye.
    const CameraPath path = make_path(PathKind::orbit, view_from({0, 8, 6}), kBall, 0.25);
    const glm::dvec3 nearest{0, 1.6, 1.2};
    EXPECT_NEAR(on_image(view_at(path, 0), nearest).x, 100, 1e-12);
    // The eye goes to the right, so the front goes to the left.
    EXPECT_NEAR(on_image(view_at(path, 1), nearest).x, 99.75, 1e-3);
    EXPECT_NEAR(path.turn_rad, 0.25 * 8 / (50 * 1.2), 1e-15);
}

// It sees 20 units in 100 px, 5 px each.
TEST(CameraPath, OfAParallelCameraMovesTheImageByItsStep) {
    const auto path_of = [](PathKind kind, const glm::dvec3& eye_world) {
        View start = view_from(eye_world);
        start.camera = projected(ProjectionKind::parallel, start.camera, kBall);
        return make_path(kind, start, kBall, 0.25);
    };
    EXPECT_NEAR(
        on_image(view_at(path_of(PathKind::orbit, {0, 8, 6}), 1), {0, 1.6, 1.2}).x, 99.75, 1e-3);
    EXPECT_NEAR(
        std::abs(on_image(view_at(path_of(PathKind::pan, {0, 0, 10}), 1), {}).x - 100), 0.25, 1e-3);
    const CameraPath dolly = path_of(PathKind::dolly, {0, 0, 10});
    EXPECT_EQ(view_at(dolly, 3).camera.eye_world, glm::dvec3(0, 0, 10));
    EXPECT_NEAR(on_image(view_at(dolly, 1), {0, 10, 0}).y, -0.25, 1e-3);
}

TEST(CameraPath, OrbitGoesFromZTowardsXAndKeepsLookingAtTheMiddle) {
    CameraPath path = make_path(PathKind::orbit, view_from({0, 6, 8}), kBall, 1);
    path.turn_rad = kRightAngle_rad / 8;
    const Camera camera = view_at(path, 8).camera;
    EXPECT_NEAR(glm::distance(camera.eye_world, {8, 6, 0}), 0, 1e-11);
    EXPECT_NEAR(on_image(view_at(path, 3), {0, 0, 0}).x, 100, 1e-9);
    EXPECT_NEAR(on_image(view_at(path, 3), {0, 0, 0}).y, 50, 1e-9);
}

TEST(CameraPath, DollyMovesTheFrameOfTheMiddlePlaneAndNeverArrives) {
    const CameraPath path = make_path(PathKind::dolly, view_from({0, 0, 10}), kBall, 0.5);
    const glm::dvec3 top{0, 10, 0};  // 45 degrees up: where the frame is
    EXPECT_NEAR(on_image(view_at(path, 0), top).y, 0, 1e-12);
    EXPECT_NEAR(on_image(view_at(path, 1), top).y, -0.5, 1e-12);
    EXPECT_GT(view_at(path, 2000).camera.eye_world.z, 0);
}

TEST(CameraPath, PanTurnsRightWhereItStands) {
    const CameraPath path = make_path(PathKind::pan, view_from({0, 0, 10}), kBall, 0.75);
    EXPECT_NEAR(on_image(view_at(path, 1), {0, 0, 0}).x, 99.25, 1e-9);
    EXPECT_NEAR(on_image(view_at(path, 1), {0, 0, 0}).y, 50, 1e-12);
    EXPECT_EQ(view_at(path, 9).camera.eye_world, glm::dvec3(0, 0, 10));
}

TEST(CameraPath, RollLeftTurnsTheImageClockwise) {
    CameraPath path = make_path(PathKind::roll, view_from({0, 0, 10}), kBall, 0.5);
    EXPECT_EQ(path.turn_rad, 0.01);
    path.turn_rad = kRightAngle_rad;
    const glm::dvec2 right = on_image(view_at(path, 0), {1, 0, 0});
    EXPECT_NEAR(right.x, 105, 1e-12);
    const glm::dvec2 turned = on_image(view_at(path, 1), {1, 0, 0});
    EXPECT_NEAR(turned.x, 100, 1e-12);
    EXPECT_NEAR(turned.y, 55, 1e-12);
}

TEST(CameraPath, ShakeStaysWithinItsStepAndFollowsItsSeed) {
    CameraPath path = make_path(PathKind::shake, view_from({0, 0, 10}), kBall, 0.5);
    bool is_left = false;
    bool is_right = false;
    bool is_up = false;
    bool is_down = false;
    for (int frame = 0; frame < 100; ++frame) {
        const glm::dvec2 moved = on_image(view_at(path, frame), {0, 0, 0}) - glm::dvec2(100, 50);
        EXPECT_LT(std::abs(moved.x), 0.5001);
        EXPECT_LT(std::abs(moved.y), 0.5001);
        is_left = is_left || moved.x < -0.4;
        is_right = is_right || moved.x > 0.4;
        is_up = is_up || moved.y < -0.4;
        is_down = is_down || moved.y > 0.4;
    }
    EXPECT_TRUE(is_left && is_right && is_up && is_down);
    const glm::dmat3 first = view_at(path, 3).camera.view_from_world;
    EXPECT_EQ(view_at(path, 3).camera.view_from_world, first);
    path.seed = 1;
    EXPECT_NE(view_at(path, 3).camera.view_from_world, first);
}

TEST(CameraPath, EveryKindTurnsRigidlyAndHoldsTheBallInItsClipRange) {
    for (const PathKind kind : path_kinds()) {
        SCOPED_TRACE(name(kind));
        const CameraPath path = make_path(kind, view_from({3, 4, 9}), kBall, 0.4);
        for (const int frame : {0, 1, 17, 400}) {
            const Camera camera = view_at(path, frame).camera;
            const glm::dmat3 m = camera.view_from_world;
            EXPECT_NEAR(glm::determinant(m), 1, 1e-12);
            EXPECT_NEAR(glm::dot(m[0], m[1]), 0, 1e-12);
            const double depth = -(m * (kBall.center_world - camera.eye_world)).z;
            EXPECT_GE(camera.far, depth + kBall.radius - 1e-9);
            EXPECT_LE(camera.near, std::max(depth - kBall.radius, 1e-3) + 1e-9);
            EXPECT_GT(camera.near, 0);
        }
    }
}

TEST(CameraPath, FrameZeroIsTheStartButForAShake) {
    for (const PathKind kind : path_kinds()) {
        if (kind == PathKind::shake) continue;
        const View start = view_from({3, 4, 9});
        const View first = view_at(make_path(kind, start, kBall, 0.4), 0);
        EXPECT_NEAR(glm::distance(first.camera.eye_world, start.camera.eye_world), 0, 1e-14);
        EXPECT_EQ(first.camera.view_from_world, start.camera.view_from_world);
    }
}

TEST(CameraPath, ImpossiblePathsAreErrors) {
    const View start = view_from({0, 0, 10});
    EXPECT_THROW((void)make_path(PathKind::pan, start, kBall, NAN), core::Error);
    EXPECT_THROW((void)make_path(PathKind::orbit, start, {{0, 0, 0}, 10}, 1), core::Error);
    EXPECT_THROW((void)make_path(PathKind::orbit, start, {{0, 0, 0}, 0}, 1), core::Error);
    EXPECT_THROW((void)make_path(PathKind::orbit, view_from({0, 9, 0}), kBall, 1), core::Error);
    EXPECT_THROW((void)make_path(PathKind::dolly, start, {{0, 0, 20}, 2}, 1), core::Error);
    EXPECT_THROW((void)make_path(PathKind::dolly, start, kBall, 50), core::Error);
    EXPECT_THROW((void)make_path(PathKind::dolly, start, kBall, -50), core::Error);
    EXPECT_THROW((void)make_path(PathKind::roll, {start.camera, 0, 0}, kBall, 1), core::Error);
}

}  // namespace
}  // namespace ink::scene
