// Methods that sample surfaces at pixel corners: what they mark, to the pixel.

#include <gtest/gtest.h>

#include "raster/pass/pass.h"
#include "scene/camera.h"
#include "scene/surface.h"
#include "tests/methods/small_scenes.h"
#include "tests/raster/gather_sink.h"

namespace ink::methods {
namespace {

const core::ParamValues kCorners = {{"samples", "corner"}};

/// A rectangle seen face-on, with its borders at these places of a width_px x height_px image.
struct SeenRectangle {
    int width_px;
    int height_px;
    double left_px, right_px, top_px, bottom_px;

    [[nodiscard]] scene::View view() const { return face_on(width_px, height_px); }
    [[nodiscard]] scene::Scene scene() const {
        const double unit = 4 / scene::Projection(view()).focal_px();
        const auto x = [&](double px) { return static_cast<float>((px - width_px / 2.0) * unit); };
        const auto y = [&](double px) { return static_cast<float>((height_px / 2.0 - px) * unit); };
        scene::Mesh mesh;
        scene::add_quad(mesh,
                        {x(left_px), y(bottom_px), 0},
                        {x(right_px) - x(left_px), 0, 0},
                        {0, y(top_px) - y(bottom_px), 0});
        return scene_of({mesh});
    }
    /// The pixels that its border runs through.
    [[nodiscard]] edge::EdgeImage border() const {
        edge::EdgeImage image(width_px, height_px, 0);
        const int x0 = static_cast<int>(left_px), x1 = static_cast<int>(right_px);
        const int y0 = static_cast<int>(top_px), y1 = static_cast<int>(bottom_px);
        for (int y = y0; y <= y1; ++y) {
            for (int x = x0; x <= x1; ++x) {
                if (x == x0 || x == x1 || y == y0 || y == y1) image.at(x, y) = 255;
            }
        }
        return image;
    }
};

TEST(CornerSamples, ARectangleMarksThePixelsThatItsBorderRunsThrough) {
    for (const std::string method : {"ids", "jump_flood", "roberts"}) {
        // Wherever in their pixels the borders lie; sizes that are and are not whole tiles.
        for (const double part : {0.1, 0.4, 0.5, 0.9}) {
            for (const auto& [width_px, height_px] : {std::pair(150, 101), std::pair(192, 128)}) {
                const SeenRectangle rectangle{
                    width_px, height_px, 20 + part, 127 + part, 30 + part, 64 + part};
                EXPECT_EQ(drawn(method, kCorners, rectangle.scene(), {rectangle.view(), 1}),
                          rectangle.border())
                    << method << " " << part << " " << width_px;
            }
        }
    }
}

TEST(CornerSamples, ARectangleBeyondTheImageMarksNothing) {
    const SeenRectangle rectangle{128, 64, -3, 131, -3, 67};
    for (const std::string method : {"ids", "jump_flood", "roberts"}) {
        const auto image = drawn(method, kCorners, rectangle.scene(), {rectangle.view(), 1});
        EXPECT_EQ(image, edge::EdgeImage(128, 64, 0)) << method;
    }
}

TEST(CornerSamples, IdsMarkAPixelIfAnyOfItsFourCornersDiffers) {
    const scene::Scene scene = cube_on_floor();
    for (const auto& size_px : {std::pair(150, 101), std::pair(128, 128)}) {
        const scene::View view = view_from(scene, {4, 3, 6}, {0, 0, 0}, size_px);
        const scene::View corners = scene::corner_view(view);
        const scene::Surface surface = scene::flatten(scene);
        const scene::Projection projection(corners);
        raster::TestMesh mesh;
        for (const glm::dvec3& p : surface.p_world)
            mesh.p_clip.push_back(projection.to_clip(p));
        mesh.triangles = surface.triangles;
        raster::PassInput input = mesh.input();
        input.near = view.camera.near;
        const auto drawn_ids = raster::draw_ids(input, corners.width_px, corners.height_px);
        const auto& ids = drawn_ids.planes[0];
        edge::EdgeImage expected(view.width_px, view.height_px, 0);
        for (int y = 0; y < view.height_px; ++y) {
            for (int x = 0; x < view.width_px; ++x) {
                const std::uint32_t id = ids.at(x, y);
                const bool is_same =
                    ids.at(x + 1, y) == id && ids.at(x, y + 1) == id && ids.at(x + 1, y + 1) == id;
                expected.at(x, y) = is_same ? 0 : 255;
            }
        }
        EXPECT_EQ(drawn("ids", {{"samples", "corner"}, {"of", "triangle"}}, scene, {view, 1}),
                  expected)
            << size_px.first;
    }
}

}  // namespace
}  // namespace ink::methods
