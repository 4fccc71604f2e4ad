#include "scene/views/framing.h"

#include <gmock/gmock.h>

#include <glm/common.hpp>

#include "core/error.h"
#include "tests/core/error_text.h"
#include "tests/scene/small_meshes.h"

namespace ink::scene {
namespace {

constexpr double kAspect = 16.0 / 9;

/// Half of the frame's width and height that the points reach from its middle, as shares.
glm::dvec2 reach(const std::vector<glm::dvec3>& points, const Camera& camera) {
    const Projection projection(View{camera, 1600, 900});
    glm::dvec2 share{0};
    for (const glm::dvec3& p : points) {
        const glm::dvec3 clip = projection.to_clip(p);
        const glm::dvec2 px = glm::dvec2(clip) / clip.z;
        share = glm::max(share, glm::abs(px / glm::dvec2(800, 450) - 1.0));
    }
    return share;
}

/// Two triangles, ten apart.
Scene two_things() {
    Scene scene = scene_of(Mesh{"t", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {{0, 1, 2}}, {}});
    scene.instances.front().name = "near";
    Instance other = scene.instances.front();
    other.name = "far";
    other.world_from_object[3].x = 10;
    scene.instances.push_back(other);
    return scene;
}

TEST(Framing, AFittedViewReachesItsMarginAndNoFurther) {
    const Scene scene = two_things();
    const auto points = placed_points(scene);
    ASSERT_EQ(points.size(), 6U);
    for (const Camera& camera : orbit_cameras(bounding_sphere(scene), 5, kAspect)) {
        const Camera fitted = framed(camera, points, kAspect, 0.8, scene);
        const glm::dvec2 share = reach(points, fitted);
        EXPECT_NEAR(std::max(share.x, share.y), 0.8, 1e-9) << camera.name;
        EXPECT_GT(fitted.near, 0);
        EXPECT_EQ(fitted.view_from_world, camera.view_from_world) << "it moves, it does not turn";
    }
}

TEST(Framing, AParallelViewIsAsHighAsItsPointsAndCutsNothing) {
    const Scene scene = two_things();
    const Sphere bounds = bounding_sphere(scene);
    const auto points = placed_points(scene);
    for (const Camera& camera : orbit_cameras(bounds, 5, kAspect)) {
        const Camera parallel = projected(ProjectionKind::parallel, camera, bounds);
        const Camera fitted = framed(parallel, points, kAspect, 0.8, scene);
        EXPECT_TRUE(fitted.is_parallel());
        const glm::dvec2 share = reach(points, fitted);
        EXPECT_NEAR(std::max(share.x, share.y), 0.8, 1e-9) << camera.name;
        for (const glm::dvec3& p : points) {
            const double depth = -(fitted.view_from_world * (p - fitted.eye_world)).z;
            EXPECT_GT(depth, fitted.near);
            EXPECT_LT(depth, fitted.far);
        }
    }
}

TEST(Framing, VerticesWithoutATriangleDoNotCount) {
    Scene scene = two_things();
    scene.meshes.front().positions.emplace_back(1000, 1000, 1000);
    EXPECT_EQ(placed_points(scene).size(), 6U);
}

TEST(Framing, OneObjectAloneIsFramed) {
    const Scene scene = two_things();
    const std::string names[] = {"far"};
    const Scene part = only_objects(scene, names);
    ASSERT_EQ(part.instances.size(), 1U);
    EXPECT_NEAR(bounding_sphere(part).center_world.x, 10.5, 1e-9);
}

TEST(Framing, AnUnknownObjectListsTheKnownOnes) {
    const std::string names[] = {"fra"};
    EXPECT_THAT(core::error_text([&] { return only_objects(two_things(), names); }),
                testing::ContainsRegex("'fra'.*far"));
}

TEST(Framing, OnePlaceLeavesTheCameraAsItIs) {
    const Scene scene = two_things();
    const Camera camera = orbit_cameras(bounding_sphere(scene), 1, kAspect).front();
    const std::vector<glm::dvec3> points(3, glm::dvec3(1, 2, 3));
    EXPECT_EQ(framed(camera, points, kAspect, 0.9, scene).eye_world, camera.eye_world);
}

}  // namespace
}  // namespace ink::scene
