#include "tests/truth/shapes.h"

// The two images of samples beside the labels, where one line or none is to be seen.

namespace ink::truth {
namespace {

TEST(Samples, AreDrawnWhereTheLineRunsThroughAPixelOrCrosses) {
    // 150 px a unit: upright sides at 320 +- 75.3 px, in the pixels 244 and 395, which show the
    // sky; level ones at 240 +- 74.7 px, in the pixels 165 and 314, which show the quad.
    const auto x = static_cast<float>(75.3 / 150), y = static_cast<float>(74.7 / 150);
    const Truth truth =
        trace(scene_of({quad({-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0})}), view_from(4));
    for (int row = 0; row < kHeight_px; ++row) {
        for (int column = 0; column < kWidth_px; ++column) {
            const bool is_upright = (column == 244 || column == 395) && row >= 165 && row <= 314;
            const bool is_level = (row == 165 || row == 314) && column >= 245 && column <= 394;
            const int expected = is_upright || is_level ? 255 : 0;
            EXPECT_EQ(truth.sampled.at(column, row), expected) << column << " " << row;
            EXPECT_EQ(truth.exact_corner.at(column, row), expected) << column << " " << row;
        }
    }
}

TEST(Samples, ShowTheCrossingOfPiercingPlanes) {
    // Two walls that cross at x = 320.3 px, with no edge there: only the depths of both walks tell.
    const auto x = static_cast<float>(0.3 / 100);
    const scene::Mesh a = quad({-9 + x, -9, -1}, {9 + x, -9, 1}, {9 + x, 9, 1}, {-9 + x, 9, -1});
    const scene::Mesh b = quad({-9 + x, -9, 1}, {9 + x, -9, -1}, {9 + x, 9, -1}, {-9 + x, 9, 1});
    const Truth truth = trace(scene_of({a, b}), view_from(6));
    for (int row = 0; row < kHeight_px; ++row) {
        for (int column = 0; column < kWidth_px; ++column) {
            ASSERT_EQ(truth.sampled.at(column, row), column == 320 ? 255 : 0) << column << row;
            ASSERT_EQ(truth.exact_corner.at(column, row), column == 320 ? 255 : 0) << column << row;
        }
    }
}

TEST(ExactCorner, SeesNothingOfABarThatPassesBetweenCorners) {
    // One wall, and before it a bar of .08 px at y = 239.8 px: a truth, and no sample on it.
    const float y = 0.2F / 100, half = 0.0004F;
    const scene::Mesh wall = quad({-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0});
    const scene::Mesh bar = quad(
        {-9, y - half, 1e-3F}, {9, y - half, 1e-3F}, {9, y + half, 1e-3F}, {-9, y + half, 1e-3F});
    const Truth truth = trace(scene_of({wall, bar}), view_from(6));
    EXPECT_GT(truth.curves.size(), 0U);
    EXPECT_EQ(drawn_px(truth.exact_corner), 0U);
}

TEST(ExactCorner, SmoothSurfaceBetweenCornersIsNoLine) {
    // A floor of many triangles that fills the frame.
    scene::Mesh floor;
    for (int z = 0; z < 40; ++z) {
        for (int x = -20; x < 20; ++x) {
            const auto p = [&](int dx, int dz) { return glm::vec3(x + dx, -1, 5 - (z + dz)); };
            add_quad(floor, p(0, 0), p(1, 0), p(1, 1), p(0, 1));
        }
    }
    scene::View view = view_from(1);
    view.camera = scene::look_at({0, 3, 0}, {0, -1, -3}, {0, 1, 0}, 0.7);
    const Truth truth = trace(scene_of({floor}), view);
    EXPECT_EQ(drawn_px(truth.exact_corner), 0U);
}

}  // namespace
}  // namespace ink::truth
