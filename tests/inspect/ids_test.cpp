#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "catalogue/shapes.h"
#include "import/import.h"
#include "tests/inspect/id_agreement.h"
#include "tests/models/fetched_model.h"
#include "tests/scene/small_meshes.h"

namespace ink::raster {
namespace {

TEST(IdsAgainstEmbree, ABallOfTrianglesLargeAndBelowAPixel) {
    for (const int levels : {1, 7}) {
        const scene::Scene scene = scene::scene_of({catalogue::make_icosphere(1, levels)});
        expect_same_ids(scene, round_views(scene, 2));
    }
}

TEST(IdsAgainstEmbree, AnEyeInsideASoupCutByTheNearPlane) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> place(-5, 5);
    scene::Mesh mesh;
    for (std::uint32_t t = 0; t < 300; ++t) {
        for (int corner = 0; corner < 3; ++corner)
            mesh.positions.emplace_back(place(random), place(random), place(random));
        mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    const scene::Scene scene = scene::scene_of(mesh);
    std::vector<scene::Camera> cameras;
    for (const double turn : {0.0, 2.0, 4.0}) {
        scene::Camera camera = scene::look_at(
            {0, 0, 0}, {std::cos(turn), 0.2, std::sin(turn)}, {0, 1, 0}, std::numbers::pi / 2);
        camera.near = 0.5;
        camera.far = 20;
        camera.name = fmt::format("turn {}", turn);
        cameras.push_back(camera);
    }
    expect_same_ids(scene, cameras);
}

/// A camera that stands in the scene.
scene::Camera inside_view(const scene::Scene& scene,
                          const glm::dvec3& eye_world,
                          const glm::dvec3& view_direction_world) {
    scene::Camera camera = scene::look_at(
        eye_world, eye_world + view_direction_world, {0, 1, 0}, std::numbers::pi / 3);
    scene::fit_clip_range(camera, scene::bounding_sphere(scene));
    camera.name = "inside";
    return camera;
}

TEST(IdsAgainstEmbree, AMapFromInside) {
    const auto path = fetched_model("aggressor.obj");
    INK_SKIP_WITHOUT(path);
    const scene::Scene scene = import::import_scene(path);
    expect_same_ids(scene,
                    {inside_view(scene, {-48, 60, -328}, {-0.31, 0.02, -0.95}),
                     inside_view(scene, {-160, 122, 0}, {-0.17, 0.02, 0.98}),
                     inside_view(scene, {200, -6, -700}, {0, 0, 1})});
}

TEST(IdsAgainstEmbree, AJeepFromOutsideAndInside) {
    const auto path = fetched_model("jeep.glb");
    INK_SKIP_WITHOUT(path);
    const scene::Scene scene = import::import_scene(path);
    std::vector<scene::Camera> cameras = round_views(scene, 3);
    const glm::dvec3 center = scene::bounding_sphere(scene).center_world;
    cameras.push_back(inside_view(scene, center, {1, 0.1, 0.3}));
    expect_same_ids(scene, cameras);
}

}  // namespace
}  // namespace ink::raster
