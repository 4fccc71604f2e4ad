#include "shade/shading.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/error.h"
#include "tests/core/error_text.h"
#include "tests/scene/small_meshes.h"

namespace ink::shade {
namespace {

constexpr int kSize_px = 65;  // so that a pixel centre lies on the view direction

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
    return scene::scene_of(mesh);
}

/// Ten away from the wall, straight on, the wall filling the picture; from the front or the back.
scene::View view_of_wall(double side) {
    scene::Camera camera =
        scene::look_at({0, 0, 10 * side}, {0, 0, 0}, {0, 1, 0}, std::numbers::pi / 4);
    camera.near = 1;
    camera.far = 20;
    return {camera, kSize_px, kSize_px};
}

const Colors kColors{.surface = glm::vec3(0.5F), .paper = {1, 0, 1}, .ink = {0, 0, 0}};

core::Image<Rgb> draw(const Style& style, const scene::Scene& scene, const scene::View& view) {
    Shader shader(style);
    shader.prepare(scene);
    return shader.draw({.view = view, .colors = kColors});
}

GouraudParams gouraud(double ambient) {
    GouraudParams params;
    params.ambient = ambient;
    return params;
}

/// Where a pixel's centre meets the wall.
glm::dvec3 wall_point(int x_px, int y_px) {
    const double per_px = 10 * std::tan(std::numbers::pi / 8) / (kSize_px / 2.0);
    return {(x_px + 0.5 - kSize_px / 2.0) * per_px, (kSize_px / 2.0 - y_px - 0.5) * per_px, 0};
}

TEST(Gouraud, ALitPlaneHasTheBrightnessOfTheFormula) {
    scene::Scene scene = wall(6, 64);
    scene.lights.push_back({.p_world = {1, 0.5, 3}, .color = {1, 0.8F, 0.6F}, .range = 9});
    const auto image = draw(gouraud(0.1), scene, view_of_wall(1));
    for (int y = 0; y < kSize_px; y += 8) {
        for (int x = 0; x < kSize_px; x += 8) {
            const glm::dvec3 to_lamp = glm::dvec3(1, 0.5, 3) - wall_point(x, y);
            const double d = glm::length(to_lamp);
            const double lamp = (3 / d) * (1 - d / 9);
            EXPECT_NEAR(image.at(x, y).r, 255 * 0.5 * (0.1 + lamp), 1) << x << " " << y;
            EXPECT_NEAR(image.at(x, y).b, 255 * 0.5 * (0.1 + 0.6 * lamp), 1) << x << " " << y;
        }
    }
}

TEST(Gouraud, OutsideALampsRangeThereIsAmbientOnlyAndTheEndCanBeSeen) {
    // The lamp stands 1 before the wall and reaches 2: its disc has the radius sqrt(3).
    scene::Scene scene = wall(6, 64);
    scene.lights.push_back({.p_world = {0, 0, 1}, .color = {1, 1, 1}, .range = 2});
    const auto image = draw(gouraud(0.1), scene, view_of_wall(1));
    const int ambient = 13;  // 255 * 0.5 * 0.1
    for (int y = 0; y < kSize_px; ++y) {
        for (int x = 0; x < kSize_px; ++x) {
            // A vertex inside the disc lights the triangles round it: one cell of slack.
            const double radius = glm::length(wall_point(x, y));
            const double cell = 12.0 / 64 * std::numbers::sqrt2;
            if (radius > std::sqrt(3.0) + cell) {
                EXPECT_EQ(image.at(x, y).g, ambient);
            } else if (radius < 0.8) {
                // At least (1 - 1.28 / 2) / 1.28 = 0.28 of the lamp.
                EXPECT_GT(image.at(x, y).g, ambient + 30);
            }
        }
    }
}

TEST(Gouraud, ABackSeenFromBehindIsLitFromBehind) {
    scene::Scene scene = wall(6, 2);
    scene.lights.push_back({.p_world = {0, 0, -4}, .color = {1, 1, 1}, .range = 0});
    const auto behind = draw(gouraud(0.1), scene, view_of_wall(-1));
    const auto before = draw(gouraud(0.1), scene, view_of_wall(1));
    EXPECT_NEAR(behind.at(32, 32).r, 255 * 0.5 * 1.1, 1);
    EXPECT_EQ(before.at(32, 32).r, 13);
}

TEST(Shader, PaperIsWhereNoSurfaceIs) {
    for (const ShadingInfo& info : shadings()) {
        const auto image = draw(info.make({}), wall(0.5, 1), view_of_wall(1));
        EXPECT_EQ(image.at(0, 0), Rgb(255, 0, 255)) << info.name;
        EXPECT_NE(image.at(32, 32), Rgb(255, 0, 255)) << info.name;
    }
}

TEST(Shader, ASceneWithoutLampsGetsSome) {
    const auto image = draw(gouraud(0.1), wall(6, 8), view_of_wall(1));
    EXPECT_GT(image.at(32, 32).r, 13 + 25);
}

TEST(Shader, ASceneWithLampsGetsNoOthers) {
    scene::Scene lit = wall(6, 8);
    lit.lights.push_back({.p_world = {0, 0, 3}, .color = {0, 1, 0}, .range = 0});
    EXPECT_EQ(draw(gouraud(0.1), lit, view_of_wall(1)).at(32, 32).r, 13) << "the lamp is green";
}

TEST(Shader, IsTheSameOnEveryThreadCount) {
    for (const ShadingInfo& info : shadings()) {
        Shader shader(info.make({}));
        shader.prepare(wall(6, 20));
        ShadeFrame frame{.view = view_of_wall(1), .colors = kColors};
        const auto one = shader.draw(frame);
        frame.threads = 4;
        EXPECT_EQ(shader.draw(frame), one) << info.name;
    }
}

TEST(Shader, AnEmptyImageStaysEmptyAndAnEmptySceneIsPaper) {
    for (const ShadingInfo& info : shadings()) {
        scene::View view = view_of_wall(1);
        const auto paper = draw(info.make({}), {}, view);
        EXPECT_EQ(paper, core::Image<Rgb>(kSize_px, kSize_px, Rgb(255, 0, 255))) << info.name;
        view.width_px = 0;
        EXPECT_TRUE(draw(info.make({}), wall(6, 1), view).is_empty()) << info.name;
    }
}

/// The colours of a picture, each once.
std::set<int> colors_of(const core::Image<Rgb>& image) {
    std::set<int> colors;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb& c = image.data()[i];
        colors.insert(c.r << 16 | c.g << 8 | c.b);
    }
    return colors;
}

/// A lamp close to the wall, so that its light varies over it.
scene::Scene unevenly_lit(scene::Scene scene) {
    scene.lights.push_back({.p_world = {2, 1, 3}, .color = {1, 1, 1}, .range = 0});
    return scene;
}

TEST(Shader, ByPatchAFlatWallHasOneColourByVertexMany) {
    // Its two halves are one patch, although they are two triangles and 128 cells.
    const scene::Scene scene = unevenly_lit(wall(6, 8));
    GouraudParams params = gouraud(0.1);
    EXPECT_GT(colors_of(draw(params, scene, view_of_wall(1))).size(), 20U);
    params.by = ShadeBy::patch;
    EXPECT_EQ(colors_of(draw(params, scene, view_of_wall(1))).size(), 1U);
}

TEST(Shader, ByPatchTheColourIsThatOfThePatchsMiddle) {
    GouraudParams params = gouraud(0.1);
    params.by = ShadeBy::patch;
    const auto image = draw(params, unevenly_lit(wall(6, 8)), view_of_wall(1));
    const double lamp = 3 / std::sqrt(14.0);  // from (2, 1, 3) to the origin
    EXPECT_NEAR(image.at(5, 5).r, 255 * 0.5 * (0.1 + lamp), 1);
}

TEST(Shader, ByFaceEveryTriangleHasOneColour) {
    GouraudParams params = gouraud(0.1);
    params.by = ShadeBy::face;
    const auto image = draw(params, unevenly_lit(wall(6, 2)), view_of_wall(1));
    EXPECT_LE(colors_of(image).size(), 8U);  // triangles of a wall of 2 x 2
    EXPECT_GE(colors_of(image).size(), 4U);
}

TEST(Shader, ToonHasAsManyColoursAsSteps) {
    ToonParams params;
    params.ambient = 0;
    params.steps = 3;
    scene::Scene scene = wall(6, 64);
    // Straight before the middle: full light there, none beyond the range.
    scene.lights.push_back({.p_world = {0, 0, 0.05}, .color = glm::vec3(1.2F), .range = 0});
    EXPECT_EQ(colors_of(draw(params, scene, view_of_wall(1))).size(), 3U);
}

TEST(Shader, GoochFacesTheLampInTheMiddle) {
    // l.n = 1 where the lamp stands: as printed cool, (0, 0, 0.4) + 0.2 * 0.5.
    GoochParams params;
    params.blue = 0.4;
    params.cool_share = 0.2;
    scene::Scene scene = wall(6, 64);
    scene.lights.push_back({.p_world = {0, 0, 100}, .color = {1, 1, 1}, .range = 1});
    const auto image = draw(params, scene, view_of_wall(1));
    EXPECT_NEAR(image.at(32, 32).r, 255 * 0.1, 1);
    EXPECT_NEAR(image.at(32, 32).b, 255 * 0.5, 1);
}

TEST(Shader, SplashbackDarkensByTheAngleToTheLamp) {
    // The lamp stands 60 degrees off the normal: (0.8 * 0.5 + 0.2)^2 = 0.36 of ambient alone.
    GouraudParams params = gouraud(1);
    params.splash_alpha = 0.8;
    params.splash_power = 2;
    scene::Scene scene = wall(6, 64);
    scene.lights.push_back(
        {.p_world = {std::sqrt(3.0) * 1e6, 0, 1e6}, .color = {1, 1, 1}, .range = 1});
    const auto image = draw(params, scene, view_of_wall(1));
    EXPECT_NEAR(image.at(32, 32).r, 255 * 0.5 * 0.36, 1);
}

TEST(Shader, StrokesAreAsFarApartAtAnySampling) {
    StrokeParams params;
    params.ambient = 0;  // the dark wall is crossed all over
    scene::Scene scene = wall(6, 1);
    scene.lights.push_back({.p_world = {0, 0, -1}, .color = {1, 1, 1}, .range = 0});
    Shader shader(params);
    shader.prepare(scene);
    const auto share = [&](int samples) {
        scene::View view = view_of_wall(1);
        view.width_px *= samples;
        view.height_px *= samples;
        const auto image =
            shader.draw({.view = view, .colors = kColors, .samples_per_px = samples});
        const auto ink = std::count(image.data(), image.data() + image.size(), Rgb(0));
        return static_cast<double>(ink) / static_cast<double>(image.size());
    };
    EXPECT_NEAR(share(1), 0.75, 0.02);
    EXPECT_NEAR(share(4), 0.75, 0.02);
}

TEST(Shadings, AreKnownByName) {
    using testing::HasSubstr;
    EXPECT_EQ(find_shading("gooch").name, "gooch");
    EXPECT_THAT(core::error_text([] { return find_shading("toom"); }),
                testing::AllOf(HasSubstr("'toom'"),
                               HasSubstr("none, gouraud, toon, gooch, strokes"),
                               HasSubstr("did you mean toon")));
}

TEST(Shadings, ParametersAreReadByNameAndRange) {
    const Style style = find_shading("toon").make({{"steps", "5"}, {"by", "patch"}});
    EXPECT_EQ(std::get<ToonParams>(style).steps, 5);
    EXPECT_EQ(std::get<ToonParams>(style).by, ShadeBy::patch);
    EXPECT_THROW((void)find_shading("toon").make({{"steps", "33"}}), core::Error);
    EXPECT_THROW((void)find_shading("gouraud").make({{"steps", "3"}}), core::Error);
    EXPECT_THROW((void)find_shading("strokes").make({{"crossed_from", "0.1"}}), core::Error);
}

}  // namespace
}  // namespace ink::shade
