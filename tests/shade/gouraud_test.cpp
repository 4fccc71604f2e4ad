#include "shade/gouraud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ink::shade {
namespace {

constexpr int kSize_px = 65;  // so that a pixel centre lies on the gaze

/// A square in the plane z = 0, half as wide as `half`, in a grid of `cells` x `cells`, front to
/// +z.
scene::Scene wall(double half, int cells) {
    scene::Mesh mesh;
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            mesh.positions.emplace_back(
                half * (2.0 * i / cells - 1), half * (2.0 * j / cells - 1), 0);
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    scene::Scene scene;
    scene.meshes.push_back(mesh);
    scene.instances.push_back({.mesh = 0, .world_from_object = glm::dmat4(1), .name = "wall"});
    return scene;
}

/// Ten away from the wall, straight on, the wall filling the picture; from the front or the back.
scene::View view_of_wall(double side) {
    scene::Camera camera =
        scene::look_at({0, 0, 10 * side}, {0, 0, 0}, {0, 1, 0}, std::numbers::pi / 4);
    camera.near = 1;
    camera.far = 20;
    return {camera, kSize_px, kSize_px};
}

GouraudOptions plain() {
    GouraudOptions options;
    options.surface = {0.5F, 0.5F, 0.5F};
    options.ambient = glm::vec3(0.1F);
    options.paper = {1, 0, 1};
    return options;
}

/// Where a pixel's centre meets the wall.
glm::dvec3 wall_point(int x_px, int y_px) {
    const double per_px = 10 * std::tan(std::numbers::pi / 8) / (kSize_px / 2.0);
    return {(x_px + 0.5 - kSize_px / 2.0) * per_px, (kSize_px / 2.0 - y_px - 0.5) * per_px, 0};
}

TEST(Gouraud, ALitPlaneHasTheBrightnessOfTheFormula) {
    scene::Scene scene = wall(6, 64);
    scene.lights.push_back({.p_world = {1, 0.5, 3}, .color = {1, 0.8F, 0.6F}, .range = 9});
    const auto picture = draw_gouraud(scene, view_of_wall(1), plain());
    for (int y = 0; y < kSize_px; y += 8) {
        for (int x = 0; x < kSize_px; x += 8) {
            const glm::dvec3 to_lamp = glm::dvec3(1, 0.5, 3) - wall_point(x, y);
            const double d = glm::length(to_lamp);
            const double lamp = (3 / d) * (1 - d / 9);
            EXPECT_NEAR(picture.at(x, y).r, 0.5 * (0.1 + lamp), 2e-3) << x << " " << y;
            EXPECT_NEAR(picture.at(x, y).b, 0.5 * (0.1 + 0.6 * lamp), 2e-3) << x << " " << y;
        }
    }
}

TEST(Gouraud, OutsideALampsRangeThereIsAmbientOnlyAndTheEndCanBeSeen) {
    // The lamp stands 1 before the wall and reaches 2: its disc has the radius sqrt(3).
    scene::Scene scene = wall(6, 64);
    scene.lights.push_back({.p_world = {0, 0, 1}, .color = {1, 1, 1}, .range = 2});
    const auto picture = draw_gouraud(scene, view_of_wall(1), plain());
    const float ambient = 0.5F * 0.1F;
    for (int y = 0; y < kSize_px; ++y) {
        for (int x = 0; x < kSize_px; ++x) {
            // A vertex inside the disc lights the triangles round it: one cell of slack.
            const double radius = glm::length(wall_point(x, y));
            const double cell = 12.0 / 64 * std::numbers::sqrt2;
            if (radius > std::sqrt(3.0) + cell) {
                EXPECT_EQ(picture.at(x, y).g, ambient);
            } else if (radius < std::sqrt(3.0) - cell) {
                EXPECT_GT(picture.at(x, y).g, ambient + 0.001F);
            }
        }
    }
}

TEST(Gouraud, ABackSeenFromBehindIsLitFromBehind) {
    scene::Scene scene = wall(6, 2);
    scene.lights.push_back({.p_world = {0, 0, -4}, .color = {1, 1, 1}, .range = 0});
    const auto behind = draw_gouraud(scene, view_of_wall(-1), plain());
    const auto before = draw_gouraud(scene, view_of_wall(1), plain());
    EXPECT_NEAR(behind.at(32, 32).r, 0.5 * 1.1, 1e-3);
    EXPECT_EQ(before.at(32, 32).r, 0.5F * 0.1F);
}

TEST(Gouraud, PaperIsWhereNoSurfaceIs) {
    const auto picture = draw_gouraud(wall(0.5, 1), view_of_wall(1), plain());
    EXPECT_EQ(picture.at(0, 0), glm::vec3(1, 0, 1));
    EXPECT_NE(picture.at(32, 32), glm::vec3(1, 0, 1));
}

TEST(Gouraud, ASceneWithoutLampsGetsSome) {
    const auto picture = draw_gouraud(wall(6, 8), view_of_wall(1), plain());
    EXPECT_GT(picture.at(32, 32).r, 0.5F * 0.1F + 0.1F);
}

TEST(Gouraud, IsTheSameOnEveryThreadCount) {
    scene::Scene scene = wall(6, 20);
    GouraudOptions options = plain();
    const auto one = draw_gouraud(scene, view_of_wall(1), options);
    options.threads = 4;
    EXPECT_EQ(draw_gouraud(scene, view_of_wall(1), options), one);
}

TEST(Gouraud, AnEmptyPictureStaysEmpty) {
    scene::View view = view_of_wall(1);
    view.width_px = 0;
    EXPECT_TRUE(draw_gouraud(wall(6, 1), view, plain()).is_empty());
}

}  // namespace
}  // namespace ink::shade
