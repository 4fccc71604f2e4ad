#include "scene/camera.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/error.h"
#include "tests/scene/small_meshes.h"

namespace ink::scene {
namespace {

constexpr double kRightAngle_rad = std::numbers::pi / 2;

TEST(Camera, LooksAlongMinusZWithYUp) {
    const Camera camera = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, kRightAngle_rad);
    const Projection projection({camera, 200, 100});
    const glm::dvec3 target = projection.to_view({0, 0, 0});
    EXPECT_EQ(target, glm::dvec3(0, 0, -5));
    EXPECT_GT(projection.to_view({1, 0, 0}).x, 0);
    EXPECT_GT(projection.to_view({0, 1, 0}).y, 0);
}

TEST(Projection, CentreIsTheMiddleOfTheImageAndYRunsDown) {
    const Camera camera = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, kRightAngle_rad);
    const Projection projection({camera, 200, 100});
    const glm::dvec3 middle = projection.to_clip({0, 0, 0});
    EXPECT_DOUBLE_EQ(middle.x / middle.z, 100);
    EXPECT_DOUBLE_EQ(middle.y / middle.z, 50);
    // 90 degrees: at distance 5 the upper frame lies 5 up.
    const glm::dvec3 top = projection.to_clip({0, 5, 0});
    EXPECT_NEAR(top.y / top.z, 0, 1e-12);
    const glm::dvec3 right = projection.to_clip({10, 0, 0});
    EXPECT_NEAR(right.x / right.z, 200, 1e-12);
}

TEST(Projection, RayHitsThePixelItWasCastThrough) {
    const Camera camera = look_at({1, 2, 3}, {-4, 0.5, 2}, {0, 1, 0.2}, 0.7);
    const Projection projection({camera, 640, 480});
    const glm::dvec3 p_clip =
        projection.to_clip(camera.eye_world + 7.0 * projection.ray_world(12.5, 400));
    EXPECT_NEAR(p_clip.x / p_clip.z, 12.5, 1e-9);
    EXPECT_NEAR(p_clip.y / p_clip.z, 400, 1e-9);
    EXPECT_NEAR(p_clip.z, 7, 1e-12);
}

TEST(Projection, ParallelDepthIsAffineAndItsLinesOfSightRunAlike) {
    Camera camera = look_at({1, 2, 3}, {-4, 0.5, 2}, {0, 1, 0.2}, 0.7);
    camera.height_world = 4;
    camera.near = 2;
    camera.far = 12;
    const Projection projection({camera, 640, 480});
    EXPECT_EQ(projection.ray_world(0, 0), projection.ray_world(640, 480));
    for (const double depth : {1.0, 2.0, 7.0, 12.0}) {
        const glm::dvec3 p_clip = projection.to_clip(projection.at(12.5, 400, depth));
        EXPECT_NEAR(p_clip.x / p_clip.z, 12.5, 1e-9);
        EXPECT_NEAR(p_clip.y / p_clip.z, 400, 1e-9);
        EXPECT_NEAR(projection.depth_of(p_clip.z), depth, 1e-12);
        EXPECT_NEAR(1 / p_clip.z, (14 - depth) / 24, 1e-12);
    }
    EXPECT_NEAR(projection.w_of(2), 2, 1e-12) << "w is the depth at near";
    EXPECT_NEAR(projection.w_of(12), 12, 1e-12) << "and at far";
    EXPECT_NEAR(projection.px_per_world(5), 120, 1e-12);
}

TEST(Camera, ProjectedEitherWaySeesAsMuchOfTheMiddle) {
    const Sphere bounds{{0, 1, 0}, 2};
    Camera pinhole = look_at({0, 1, 9}, bounds.center_world, {0, 1, 0}, kRightAngle_rad);
    fit_clip_range(pinhole, bounds);
    const Camera parallel = projected(ProjectionKind::parallel, pinhole, bounds);
    EXPECT_NEAR(parallel.height_world, 18, 1e-12);
    EXPECT_EQ(parallel.eye_world, pinhole.eye_world);
    const Camera back = projected(ProjectionKind::perspective, parallel, bounds);
    EXPECT_FALSE(back.is_parallel());
    EXPECT_NEAR(back.fov_y_rad, kRightAngle_rad, 1e-12);
    const Camera again = projected(ProjectionKind::parallel, parallel, bounds);
    EXPECT_EQ(again.height_world, parallel.height_world);
    Camera within = pinhole;
    within.eye_world = bounds.center_world;
    EXPECT_NEAR(projected(ProjectionKind::parallel, within, bounds).height_world, 14, 1e-12)
        << "what it sees where its near plane is";
}

TEST(Camera, UpAlongTheViewDirectionStillGivesARotation) {
    const Camera camera = look_at({0, 9, 0}, {0, 0, 0}, {0, 1, 0}, 0.7);
    EXPECT_NEAR(glm::determinant(camera.view_from_world), 1, 1e-12);
}

TEST(Camera, TheLengthOfUpDoesNotMatter) {
    const glm::dmat3 expected =
        look_at({0, 1, 5}, {0.3, 0, 0}, {0.25, 1, 0}, kRightAngle_rad).view_from_world;
    for (const double length : {0x1p-900, 0x1p-30, 0x1p30, 0x1p900}) {
        const glm::dvec3 up = length * glm::dvec3(0.25, 1, 0);
        EXPECT_EQ(look_at({0, 1, 5}, {0.3, 0, 0}, up, kRightAngle_rad).view_from_world, expected)
            << length;
    }
}

TEST(Camera, EyeOnTargetIsAnError) {
    EXPECT_THROW((void)look_at({1, 1, 1}, {1, 1, 1}, {0, 1, 0}, 0.7), core::Error);
    EXPECT_THROW((void)look_at({1, 1, 1}, {NAN, 1, 1}, {0, 1, 0}, 0.7), core::Error);
}

TEST(OrbitCameras, KeepTheWholeBallInTheFrame) {
    const Scene scene = scene_of(unit_cube());
    const Sphere bounds = bounding_sphere(scene);
    EXPECT_NEAR(bounds.radius, std::sqrt(3.0), 1e-12);
    for (const double aspect : {16.0 / 9, 0.5}) {
        for (const Camera& camera : orbit_cameras(bounds, 5, aspect)) {
            const Projection projection({camera, static_cast<int>(100 * aspect), 100});
            for (const glm::vec3& p : scene.meshes[0].positions) {
                const glm::dvec3 p_clip = projection.to_clip(glm::dvec3(p));
                EXPECT_GT(p_clip.z, camera.near);
                EXPECT_LT(p_clip.z, camera.far);
                EXPECT_GE(p_clip.x / p_clip.z, 0);
                EXPECT_LE(p_clip.x / p_clip.z, 100 * aspect);
                EXPECT_GE(p_clip.y / p_clip.z, 0);
                EXPECT_LE(p_clip.y / p_clip.z, 100);
            }
        }
    }
}

}  // namespace
}  // namespace ink::scene
