// Lines where they belong and as wide as the filter makes them, on images small enough to know.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/methods/names.h"
#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

/// Where row y of the image has a line: columns of edge response at least 1.
std::vector<int> line_columns(const edge::EdgeImage& image, int y) {
    std::vector<int> columns;
    for (int x = 0; x < image.width_px(); ++x) {
        if (image.at(x, y) > 0) columns.push_back(x);
    }
    return columns;
}

TEST(Image, AWallIsOutlinedAsWideAsTheFilterIs) {
    const Wall wall;
    const auto columns = [&](const std::string& method, const core::ParamValues& values) {
        return line_columns(drawn(method, values, wall.scene, {wall.view, 1}), 80);
    };
    for (const std::string method : {"mote2", "mote4", "mote16"}) {
        EXPECT_EQ(columns(method, {}), (std::vector<int>{39, 40, 119, 120})) << method;
        EXPECT_EQ(columns(method, {{"response", "positive"}}), (std::vector<int>{40, 119}))
            << method;
        EXPECT_EQ(columns(method, {{"fatten", "true"}}),
                  (std::vector<int>{38, 39, 40, 41, 118, 119, 120, 121}))
            << method;
    }
    EXPECT_EQ(columns("decaudin", {}), (std::vector<int>{38, 39, 40, 41, 118, 119, 120, 121}));
    for (const std::string method : {"roberts", "plane_distance"})
        EXPECT_EQ(columns(method, {}), (std::vector<int>{39, 119})) << method;
    EXPECT_EQ(columns("sobel", {{"order", "first"}}),
              (std::vector<int>{38, 39, 40, 41, 118, 119, 120, 121}));
    EXPECT_EQ(columns("sobel", {{"order", "both"}}),
              (std::vector<int>{38, 39, 40, 41, 118, 119, 120, 121}));
    EXPECT_EQ(columns("sobel", {{"order", "second"}}), (std::vector<int>{39, 40, 119, 120}));
    EXPECT_EQ(columns("ids", {}), (std::vector<int>{40, 119}));
    EXPECT_EQ(columns("ids", {{"side", "both"}}), (std::vector<int>{39, 40, 119, 120}));
    EXPECT_EQ(columns("jump_flood", {}), (std::vector<int>{39, 40, 119, 120}));
    EXPECT_EQ(columns("jump_flood", {{"width_px", "4"}}),
              (std::vector<int>{38, 39, 40, 41, 118, 119, 120, 121}));
    EXPECT_EQ(columns("canny", {}).size(), 2U);
}

TEST(Image, SkyAtTheWallsOwnCodeHidesIt) {
    // Depth 1 at the wall and a normal straight at the eye: 127 + 127. A sky of that code is no
    // step.
    const Wall wall;
    const auto image = drawn("mote2",
                             {{"sky", "191"}, {"normals", "facet"}, {"packing", "pixel"}},
                             wall.scene,
                             {wall.view, 1});
    const double near = 4 - std::sqrt(2.0);
    const double far = 4 + std::sqrt(2.0);
    const double depth = (1 / 4.0 - 1 / far) / (1 / near - 1 / far);
    EXPECT_EQ(std::lround(127 + 127 * depth), 168);
    EXPECT_FALSE(line_columns(image, 80).empty());
    const auto hidden = drawn("mote2",
                              {{"sky", "168"}, {"normals", "facet"}, {"packing", "pixel"}},
                              wall.scene,
                              {wall.view, 1});
    EXPECT_TRUE(line_columns(hidden, 80).empty());
}

/// `view` with `px` more pixels on every side and the same scale: pixel (x, y) becomes (x+px,
/// y+px).
scene::View widened(scene::View view, int px) {
    const double taller = (view.height_px + 2 * px) / static_cast<double>(view.height_px);
    view.camera.fov_y_rad = 2 * std::atan(std::tan(view.camera.fov_y_rad / 2) * taller);
    view.width_px += 2 * px;
    view.height_px += 2 * px;
    return view;
}

TEST(Image, TilesLeaveNoSeam) {
    // The same image with its tiles elsewhere. A focal length that rounds otherwise may move a
    // vertex by a 256th of a pixel here and there; a seam would show along whole tiles.
    constexpr int kShift_px = 11;
    const scene::Scene scene = cube_on_floor();
    const scene::View view = view_from(scene, {4, 3, 6}, {0, 0, 0}, {200, 150});
    for (const method::MethodInfo& info : registry()) {
        const auto image = drawn(info.name, {}, scene, {view, 1});
        const auto moved = drawn(info.name, {}, scene, {widened(view, kShift_px), 1});
        int differing = 0;
        for (int y = 2; y + 2 < view.height_px; ++y) {
            for (int x = 2; x + 2 < view.width_px; ++x) {
                differing += image.at(x, y) != moved.at(x + kShift_px, y + kShift_px);
            }
        }
        EXPECT_LE(differing, 8) << info.name;
    }
}

TEST(Image, ATriangleSeenFromItsBackUsesTheNegatedNormal) {
    scene::Scene front = cube_on_floor();
    scene::Scene back = front;
    for (scene::Mesh& mesh : back.meshes) {
        for (scene::Triangle& triangle : mesh.triangles)
            std::swap(triangle[1], triangle[2]);
    }
    const scene::View view = view_from(front, {4, 3, 6}, {0, 0, 0}, {150, 101});
    for (const method::MethodInfo& info : registry()) {
        if (knows_sides(info.name)) continue;
        EXPECT_EQ(drawn(info.name, {}, front, {view, 1}), drawn(info.name, {}, back, {view, 1}))
            << info.name;
    }
}

TEST(Image, PackingAtPixelsDiffersFromPackingAtVerticesByRoundingAlone) {
    const scene::Scene scene = cube_on_floor();
    const scene::View view = view_from(scene, {4, 3, 6}, {0, 0, 0}, {150, 101});
    const auto vertex = drawn("mote4", {{"clip_bits", "0"}}, scene, {view, 1});
    const auto pixel = drawn("mote4", {{"clip_bits", "0"}, {"packing", "pixel"}}, scene, {view, 1});
    int differing = 0;
    for (int y = 0; y < 101; ++y) {
        for (int x = 0; x < 150; ++x) {
            EXPECT_LE(std::abs(vertex.at(x, y) - pixel.at(x, y)), 4);
            differing += vertex.at(x, y) != pixel.at(x, y);
        }
    }
    EXPECT_LT(differing, 150 * 101 / 100);
}

int strongest_round(const edge::EdgeImage& image, const glm::ivec2& at) {
    int strongest = 0;
    for (int y = at.y - 2; y <= at.y + 2; ++y) {
        for (int x = at.x - 2; x <= at.x + 2; ++x)
            strongest = std::max<int>(strongest, image.at(x, y));
    }
    return strongest;
}

TEST(Image, ACubesEdgesAreDrawnAndItsFacesAreNot) {
    const scene::Scene scene = scene_of({cube_mesh()});
    const scene::View view = view_from(scene, {5, 4, 2}, {0, 0, 0}, {200, 200});
    const auto pixel = [&](const glm::dvec3& p_world) {
        const glm::dvec3 p = scene::Projection(view).to_clip(p_world);
        return glm::ivec2(glm::dvec2(p.x, p.y) / p.z);
    };
    for (const method::MethodInfo& info : registry()) {
        if (!draws_polyhedra(info.name)) continue;
        const int threshold = std::stoi(info.complete({}).at("threshold"));
        const auto image = drawn(info.name, {}, scene, {view, 1});
        for (const glm::dvec3 crease : {glm::dvec3(1, 0, 1), {1, 1, 0}, {0, 1, 1}}) {
            const int strongest = strongest_round(image, pixel(crease));
            EXPECT_EQ(strongest >= threshold, draws_creases(info.name)) << info.name;
        }
        for (const glm::dvec3 contour : {glm::dvec3(1, -1, 0), {1, 0, -1}, {0, -1, 1}}) {
            EXPECT_GE(strongest_round(image, pixel(contour)), threshold) << info.name;
        }
        for (const glm::dvec3 face : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}}) {
            EXPECT_EQ(strongest_round(image, pixel(face)), 0) << info.name;
        }
    }
}

}  // namespace
}  // namespace ink::methods
