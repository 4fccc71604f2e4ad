#include "score/offset.h"

#include <gtest/gtest.h>

#include "tests/score/curves.h"

namespace {

using ink::score::Offsets;
using ink::score::PixelList;
using ink::truth::LineClass;

Offsets offsets_of(const Image& drawn, const Curves& curves) {
    return measure_offsets(
        PixelList(drawn),
        ink::score::find_nearest_curves(curves, drawn.width_px(), drawn.height_px()));
}

Image pixel(int x, int y, int width_px = 20, int height_px = 20) {
    Image image(width_px, height_px);
    image.at(x, y) = 1;
    return image;
}

TEST(Offsets, OfLinesWithTwoSidesArePositiveToTheRightOrDown) {
    const Curves upright = {curve(8.25, 0, 8.25, 20)};
    EXPECT_DOUBLE_EQ(*offsets_of(pixel(9, 5), upright).all.mean(), 1.25);
    EXPECT_DOUBLE_EQ(*offsets_of(pixel(7, 5), upright).all.mean(), -0.75);
    const Curves back = {curve(8.25, 20, 8.25, 0)};
    EXPECT_DOUBLE_EQ(*offsets_of(pixel(9, 5), back).all.mean(), 1.25);
    const Curves level = {curve(20, 8.25, 0, 8.25)};
    EXPECT_DOUBLE_EQ(*offsets_of(pixel(5, 9), level).all.mean(), 1.25);
    EXPECT_DOUBLE_EQ(*offsets_of(pixel(5, 7), level).all.mean(), -0.75);
    // y = x / 2: shallow, so down is positive; (4.5, 6.5) lies 4.25 below it, times cos.
    const Curves shallow = {curve(0, 0, 20, 10)};
    EXPECT_NEAR(*offsets_of(pixel(8, 5), shallow).all.mean(), 1.25 * 2 / std::sqrt(5), 1e-12);
    const Curves steep = {curve(0, 0, 10, 20)};
    EXPECT_NEAR(*offsets_of(pixel(5, 8), steep).all.mean(), 1.25 * 2 / std::sqrt(5), 1e-12);
}

TEST(Offsets, OfOneSidedLinesArePositiveToTheEmptySide) {
    // Going down, the right-hand side on the image is -x.
    ink::truth::Curve contour = curve(8.25, 0, 8.25, 20, LineClass::contour);
    contour.empty_side = 1;
    EXPECT_DOUBLE_EQ(*offsets_of(pixel(9, 5), {contour}).all.mean(), -1.25);
    contour.empty_side = -1;
    EXPECT_DOUBLE_EQ(*offsets_of(pixel(9, 5), {contour}).all.mean(), 1.25);
    // Going right, the right-hand side is +y.
    ink::truth::Curve boundary = curve(0, 8.25, 20, 8.25, LineClass::boundary);
    boundary.empty_side = 1;
    EXPECT_DOUBLE_EQ(*offsets_of(pixel(5, 9), {boundary}).all.mean(), 1.25);
}

TEST(Offsets, HaveMeanSpreadAndRootMeanSquare) {
    Image drawn(20, 20);
    for (int y = 2; y < 18; ++y)
        drawn.at(y % 4 == 0 ? 7 : 9, y) = 1;  // -0.5 four times and 1.5 twelve times
    const Offsets o = offsets_of(drawn, {curve(8, 0, 8, 20, LineClass::seam)});
    EXPECT_EQ(o.all.n, 16);
    EXPECT_DOUBLE_EQ(*o.all.mean(), 1);
    EXPECT_DOUBLE_EQ(*o.all.rms(), std::sqrt((4 * 0.25 + 12 * 2.25) / 16));
    EXPECT_DOUBLE_EQ(*o.all.spread(), std::sqrt((4 * 2.25 + 12 * 0.25) / 16));
    EXPECT_EQ(o.classes[5].n, 16);
    EXPECT_EQ(o.classes[3].n, 0);
}

TEST(Offsets, ReachTwoPixels) {
    const Curves upright = {curve(8.5, 0, 8.5, 20)};
    EXPECT_EQ(offsets_of(pixel(10, 5), upright).all.n, 1);
    EXPECT_EQ(offsets_of(pixel(11, 5), upright).all.n, 0);
    EXPECT_EQ(offsets_of(pixel(6, 5), upright).all.n, 1);
    EXPECT_EQ(offsets_of(pixel(5, 5), upright).all.n, 0);
}

TEST(Offsets, AreTakenFromTheNearestCurve) {
    const Curves two = {curve(5.5, 0, 5.5, 20, LineClass::contour),
                        curve(8.25, 0, 8.25, 20, LineClass::seam)};
    const Offsets o = offsets_of(pixel(7, 4), two);
    EXPECT_DOUBLE_EQ(*o.all.mean(), -0.75);
    EXPECT_EQ(o.classes[5].n, 1);
    EXPECT_EQ(o.classes[1].n, 0);
}

TEST(Offsets, EndWhereALineEndsButGoRoundItsCorners) {
    // A line's end at (8.5, 8.5), the line going up from it.
    const Curves end = {curve(8.5, 0.5, 8.5, 8.5)};
    EXPECT_EQ(offsets_of(pixel(8, 8), end).all.n, 1);
    EXPECT_EQ(offsets_of(pixel(8, 9), end).all.n, 0);  // ahead of it
    EXPECT_EQ(offsets_of(pixel(9, 9), end).all.n, 1);  // as far across as ahead
    // A right angle at (8.5, 8.5): the pixel outside the corner is seen by both legs.
    const Curves corner = {curve(8.5, 0.5, 8.5, 8.5), curve(8.5, 8.5, 0.5, 8.5)};
    const Offsets o = offsets_of(pixel(9, 9), corner);
    EXPECT_EQ(o.all.n, 1);
    EXPECT_DOUBLE_EQ(*o.all.mean(), std::sqrt(2));
}

/// The pixels that a circle of this radius runs through, moved by (dx, dy).
Image ring(double radius, double dx, double dy) {
    Image image(100, 100);
    for (int i = 0; i < 6000; ++i) {
        const double turn = 2 * std::numbers::pi * i / 6000;
        image.at(static_cast<int>(std::floor(50.2 + dx + radius * std::cos(turn))),
                 static_cast<int>(std::floor(49.7 + dy + radius * std::sin(turn)))) = 1;
    }
    return image;
}

TEST(Offsets, OfARoundDrawnOutsideArePositiveAndNoShift) {
    const Curves truth = circle(50.2, 49.7, 30, 500);
    for (const double outside : {-1.0, 0.0, 0.5, 1.0}) {
        const Offsets o = offsets_of(ring(30 + outside, 0, 0), truth);
        EXPECT_NEAR(*o.all.mean(), outside, 0.05) << outside;
        // A pixel that a line runs through has its centre anywhere up to 0.7 px beside it.
        EXPECT_NEAR(*o.all.spread(), 0.34, 0.05) << outside;
        ASSERT_TRUE(o.shift.has_value());
        EXPECT_NEAR(o.shift->x_px, 0, 0.06);
        EXPECT_NEAR(o.shift->y_px, 0, 0.06);
    }
}

TEST(Offsets, OfAnImageMovedAsAWholeAreAShift) {
    const Curves truth = circle(50.2, 49.7, 30, 500);
    const Offsets o = offsets_of(ring(30, 0.5, -1), truth);
    EXPECT_NEAR(*o.all.mean(), 0, 0.05);
    EXPECT_NEAR(o.shift->x_px, 0.5, 0.06);
    EXPECT_NEAR(o.shift->y_px, -1, 0.06);
    EXPECT_FALSE(offsets_of(pixel(9, 5), {curve(8, 0, 8, 20)}).shift.has_value());
}

TEST(Offsets, OfNothingAreNoNumber) {
    const Curves line = {curve(8, 0, 8, 20)};
    for (const Offsets& o : {offsets_of(Image(20, 20), line),
                             offsets_of(pixel(3, 3), {}),
                             offsets_of(pixel(8, 3), {curve(8, 3, 8, 3)}),
                             offsets_of(Image(), line)}) {
        EXPECT_EQ(o.all.n, 0);
        EXPECT_FALSE(o.all.mean().has_value());
        EXPECT_FALSE(o.all.spread().has_value());
        EXPECT_FALSE(o.all.rms().has_value());
        EXPECT_FALSE(o.shift.has_value());
    }
}

}  // namespace
