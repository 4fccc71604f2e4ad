#include "truth/label_image.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "edge/thin.h"
#include "tests/truth/shapes.h"

namespace ink::truth {
namespace {

constexpr double kCrease_rad = 0.7;

Curve line(LineClass line_class, double x0, double y0, double x1, double y1) {
    return {.line_class = line_class, .begin = {x0, y0, 1}, .end = {x1, y1, 1}};
}

std::size_t count(const LabelImage& image, LineClass line_class) {
    return static_cast<std::size_t>(std::count(image.labels.data(),
                                               image.labels.data() + image.labels.size(),
                                               static_cast<std::uint8_t>(line_class)));
}

edge::Mask lines_of(const LabelImage& image) {
    edge::Mask mask(image.labels.width_px(), image.labels.height_px());
    for (std::size_t i = 0; i < image.labels.size(); ++i) {
        const std::uint8_t label = image.labels.data()[i];
        mask.data()[i] = label != 0 && label != static_cast<std::uint8_t>(LineClass::ignore);
    }
    return mask;
}

TEST(LabelImage, PixelsAreRoundedDown) {
    const std::vector<Curve> curves = {line(LineClass::crease, 3.9, 5.1, 9.2, 5.9)};
    const LabelImage image = draw_labels(curves, 16, 16, kCrease_rad);
    EXPECT_EQ(count(image, LineClass::crease), 7U);
    for (int x = 3; x <= 9; ++x)
        EXPECT_EQ(image.labels.at(x, 5), 3);
}

TEST(LabelImage, LowerLabelWins) {
    const std::vector<Curve> curves = {line(LineClass::seam, 1.5, 4.5, 30.5, 4.5),
                                       line(LineClass::contour, 8.5, 4.5, 12.5, 4.5),
                                       line(LineClass::boundary, 10.5, 4.5, 20.5, 4.5)};
    const LabelImage image = draw_labels(curves, 32, 16, kCrease_rad);
    EXPECT_EQ(count(image, LineClass::contour), 5U);
    EXPECT_EQ(count(image, LineClass::boundary), 8U);
    EXPECT_EQ(count(image, LineClass::seam), 17U);
}

TEST(LabelImage, WhatTouchesTheFrameFromOutsideIsLeftOut) {
    const std::vector<Curve> curves = {line(LineClass::contour, 0, 16, 16, 16),
                                       line(LineClass::contour, 16, 0, 16, 16)};
    EXPECT_EQ(count(draw_labels(curves, 16, 16, kCrease_rad), LineClass::contour), 0U);
}

TEST(LabelImage, UnionIsThinnedAndTheLossCounted) {
    // Two lines a pixel apart fill two rows; one row is left.
    const std::vector<Curve> curves = {line(LineClass::contour, 2.5, 4.5, 40.5, 4.5),
                                       line(LineClass::crease, 2.5, 5.5, 40.5, 5.5)};
    const LabelImage image = draw_labels(curves, 48, 16, kCrease_rad);
    const std::size_t left = count(image, LineClass::contour) + count(image, LineClass::crease);
    EXPECT_EQ(image.merged_px, 2 * 39 - left);
    EXPECT_LE(left, 40U);
    EXPECT_GE(left, 37U);
    EXPECT_EQ(image.crowded_share, 0);
}

/// An intersection that bends by `deviation_rad`.
Curve bent(double deviation_rad, double x0, double y0, double x1, double y1) {
    Curve curve = line(LineClass::intersection, x0, y0, x1, y1);
    curve.deviation_rad = static_cast<float>(deviation_rad);
    return curve;
}

TEST(LabelImage, IntersectionsBelowTheCreaseAngleKeepTheirLabelAndAreMarked) {
    const std::vector<Curve> curves = {bent(kCrease_rad - 0.01, 2.5, 4.5, 40.5, 4.5),
                                       bent(kCrease_rad, 2.5, 10.5, 40.5, 10.5),
                                       line(LineClass::crease, 20.5, 1.5, 20.5, 13.5)};
    const LabelImage image = draw_labels(curves, 48, 16, kCrease_rad);
    EXPECT_EQ(image.labels.at(10, 4), 4);
    EXPECT_EQ(image.below_crease.at(10, 4), 1);
    EXPECT_EQ(image.labels.at(10, 10), 4);
    EXPECT_EQ(image.below_crease.at(10, 10), 0) << "just the angle is not below";
    EXPECT_EQ(image.labels.at(20, 4), 3);
    EXPECT_EQ(image.below_crease.at(20, 4), 0) << "the crease counts";
    for (std::size_t i = 0; i < image.labels.size(); ++i)
        EXPECT_TRUE(image.below_crease.data()[i] == 0 || image.labels.data()[i] == 4);
}

TEST(LabelImage, AFlatIntersectionUnderABentOneCounts) {
    const std::vector<Curve> curves = {bent(0.1, 2.5, 4.5, 40.5, 4.5),
                                       bent(1, 2.5, 4.5, 20.5, 4.5)};
    const LabelImage image = draw_labels(curves, 48, 16, kCrease_rad);
    EXPECT_EQ(image.below_crease.at(10, 4), 0);
    EXPECT_EQ(image.below_crease.at(30, 4), 1);
}

TEST(LabelImage, FilledBlocksAndTheirNeighboursAreIgnored) {
    // Seven rows of the block at (24, 24)..(31, 31): 56 of 64 pixels, more than three quarters.
    std::vector<Curve> curves;
    for (int row = 24; row < 31; ++row)
        curves.push_back(line(LineClass::crease, 24.5, row + 0.5, 31.5, row + 0.5));
    curves.push_back(line(LineClass::contour, 2.5, 50.5, 61.5, 50.5));
    const LabelImage image = draw_labels(curves, 64, 64, kCrease_rad);
    EXPECT_EQ(count(image, LineClass::ignore), 24U * 24U);
    EXPECT_EQ(image.labels.at(16, 16), 7);
    EXPECT_EQ(image.labels.at(39, 39), 7);
    EXPECT_EQ(image.labels.at(40, 39), 0);
    EXPECT_EQ(count(image, LineClass::crease), 0U);
    EXPECT_EQ(count(image, LineClass::contour), 60U);
    EXPECT_DOUBLE_EQ(image.crowded_share, 56.0 / (56 + 60));
}

TEST(LabelImage, ThreeQuartersAreNotYetCrowded) {
    std::vector<Curve> curves;
    for (int row = 24; row < 30; ++row)
        curves.push_back(line(LineClass::crease, 24.5, row + 0.5, 31.5, row + 0.5));
    EXPECT_EQ(count(draw_labels(curves, 64, 64, kCrease_rad), LineClass::ignore), 0U);
}

TEST(LabelImage, BlocksAtTheBorderAreJudgedByWhatTheyHave) {
    // An image 20 px wide: its last column of blocks is 4 px wide. Seven full rows there are 28
    // of 32.
    std::vector<Curve> curves;
    for (int row = 8; row < 15; ++row)
        curves.push_back(line(LineClass::crease, 16.5, row + 0.5, 19.5, row + 0.5));
    EXPECT_EQ(count(draw_labels(curves, 20, 32, kCrease_rad), LineClass::ignore), (8U + 4U) * 24U);
}

TEST(LabelImage, ThinningTheResultChangesNothing) {
    Noise noise(11);
    std::vector<Curve> curves;
    for (int i = 0; i < 120; ++i) {
        const double x = 200 * noise.next(), y = 150 * noise.next();
        curves.push_back(line(kLineClasses[static_cast<std::size_t>(5 * noise.next())],
                              x,
                              y,
                              x + 60 * noise.next() - 30,
                              y + 60 * noise.next() - 30));
    }
    for (int i = 0; i < 40; ++i)
        curves.push_back(line(LineClass::crease, 100, 60 + 0.4 * i, 150, 60 + 0.5 * i));
    const LabelImage image = draw_labels(curves, 200, 150, kCrease_rad);
    ASSERT_GT(count(image, LineClass::ignore), 0U);
    const edge::Mask mask = lines_of(image);
    EXPECT_GT(std::count(mask.data(), mask.data() + mask.size(), 1), 1000);
    EXPECT_EQ(edge::thin(mask), mask);
}

}  // namespace
}  // namespace ink::truth
