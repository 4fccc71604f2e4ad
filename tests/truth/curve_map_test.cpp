
#include <gtest/gtest.h>

#include "tests/truth/shapes.h"
#include "truth/label_image.h"

namespace ink::truth {
namespace {

Curve level(LineClass line_class, double x0, double x1, double y) {
    return {.line_class = line_class, .begin = {x0, y, 1}, .end = {x1, y, 1}};
}

TEST(CurveMap, NamesTheLowestClassAndOfThoseTheFirst) {
    const std::vector<Curve> curves = {level(LineClass::seam, 1.5, 20.5, 4.5),
                                       level(LineClass::contour, 5.5, 8.5, 4.5),
                                       level(LineClass::contour, 7.5, 12.5, 4.5)};
    const auto map = draw_curve_map(curves, 24, 8);
    const auto row = [&](int x) { return map.at(x, 4); };
    for (const int x : {1, 4, 13, 20})
        EXPECT_EQ(row(x), 0U) << x;
    for (const int x : {5, 8})
        EXPECT_EQ(row(x), 1U) << x;
    for (const int x : {9, 12})
        EXPECT_EQ(row(x), 2U) << x;
    EXPECT_EQ(row(0), kNoCurve);
    EXPECT_EQ(row(21), kNoCurve);
    EXPECT_EQ(map.at(4, 3), kNoCurve);
}

TEST(CurveMap, HasACurveOfTheLabelUnderEachTruthPixel) {
    const scene::Scene scene = scene_of({box({-1, -1, -1}, {1, 1, 1})});
    const scene::View view = view_from({3, 2, 5}, {0, 0, 0});
    const Truth truth = trace(scene, view);
    const auto map = draw_curve_map(truth.curves, view.width_px, view.height_px);
    int n = 0;
    for (int y = 0; y < view.height_px; ++y) {
        for (int x = 0; x < view.width_px; ++x) {
            const int label = truth.labels.at(x, y);
            if (label == 0 || label == 7) continue;
            ASSERT_NE(map.at(x, y), kNoCurve);
            ASSERT_EQ(static_cast<int>(truth.curves[map.at(x, y)].line_class), label);
            ++n;
        }
    }
    EXPECT_GT(n, 500);
}

}  // namespace
}  // namespace ink::truth
