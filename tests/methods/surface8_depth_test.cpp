// A ridge that hides the sheet behind it: one patch with one code, and a step of depth.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

/// A sheet from z = 2 to z = -2, with a ridge along the x axis; smooth everywhere.
scene::Mesh ridge() {
    constexpr std::uint32_t kRows = 80;
    scene::Mesh mesh;
    for (std::uint32_t i = 0; i <= kRows; ++i) {
        const float z = 2 - 4 * static_cast<float>(i) / kRows;
        const float y = 0.8F * std::exp(-8 * z * z);
        mesh.positions.push_back({-2, y, z});
        mesh.positions.push_back({2, y, z});
        if (i == 0) continue;
        mesh.triangles.push_back({2 * i - 2, 2 * i - 1, 2 * i});
        mesh.triangles.push_back({2 * i - 1, 2 * i + 1, 2 * i});
    }
    return mesh;
}

class Surface8Depth : public testing::Test {
  protected:
    [[nodiscard]] edge::EdgeImage draw(core::ParamValues values,
                                       const std::string& method = "surface8_depth") const {
        values["turn_deg"] = "180";  // one code
        return drawn(method, values, scene_, {view_, 1});
    }
    /// Pixels inside the sheet's image that are lines.
    [[nodiscard]] static int inner_lines(const edge::EdgeImage& image) {
        int lines = 0;
        for (int y = 30; y < 70; ++y) {
            const std::uint8_t* row = image.row(y);
            lines += static_cast<int>(std::count(row + 50, row + 100, 255));
        }
        return lines;
    }

    const scene::Scene scene_ = scene_of({ridge()});
    const scene::View view_ = view_from(scene_, {0, 4, 5}, {0, 0, 0}, {150, 101});
};

TEST_F(Surface8Depth, FindsTheContourThatOneCodeHides) {
    for (const std::string samples : {"corner", "centre"}) {
        const core::ParamValues values = {{"samples", samples}};
        EXPECT_EQ(inner_lines(draw(values, "surface8")), 0);
        const int lines = inner_lines(draw(values));
        EXPECT_GE(lines, 50) << "one in each column";
        EXPECT_LE(lines, 60);
    }
}

TEST_F(Surface8Depth, DrawsTheSameInEveryDepthFormat) {
    const edge::EdgeImage image = draw({});
    EXPECT_EQ(image, draw({{"depth_format", "z24"}}));
    EXPECT_EQ(image, draw({{"depth_format", "z16"}}));
}

TEST_F(Surface8Depth, IsSurface8WhereNoJumpIsLargeEnough) {
    const edge::EdgeImage image = draw({}, "surface8");
    EXPECT_NE(image, draw({}));
    EXPECT_EQ(image, draw({{"jump_px", "1000"}}));
}

TEST_F(Surface8Depth, TakesRoundingForNoJump) {
    // Near the eye's end of the range a step of z16 is most of the sheet's depth.
    scene::View view = view_;
    view.camera.near = 1e-3;
    const auto image = drawn("surface8_depth",
                             {{"turn_deg", "180"}, {"depth_format", "z16"}, {"jump_px", "0.1"}},
                             scene_of({floor_mesh(40)}),
                             {view, 1});
    EXPECT_EQ(inner_lines(image), 0);
}

}  // namespace
}  // namespace ink::methods
