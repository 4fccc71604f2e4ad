#include "score/line_width.h"

#include <gtest/gtest.h>

#include "tests/score/curves.h"

namespace {

using ink::score::ScoreOptions;
using ink::score::Widths;

Widths widths_of(const Image& drawn, const Curves& curves, const ScoreOptions& options = {}) {
    const auto truth = prepare_truth(Image(drawn.width_px(), drawn.height_px()), options, false);
    return measure_widths(drawn, place_probes(curves, truth, options));
}

TEST(Widths, OfLevelAndUprightBandsAreTheirRows) {
    for (const int width : {1, 2, 3, 5}) {
        const auto level = drawn_where(120, 40, [&](double, double y) {
            return y > 20 - width / 2 && y < 20 - width / 2 + width;
        });
        const Widths w = widths_of(level, {curve(10, 20.4, 110, 20.4)});
        EXPECT_EQ(w.all.n, 100);
        EXPECT_DOUBLE_EQ(*w.all.mean(), width);
        EXPECT_NEAR(*w.all.spread(), 0, 1e-6);
        const auto upright = drawn_where(40, 120, [&](double x, double) {
            return x > 20 - width / 2 && x < 20 - width / 2 + width;
        });
        EXPECT_DOUBLE_EQ(*widths_of(upright, {curve(20.4, 10, 20.4, 110)}).all.mean(), width);
    }
}

TEST(Widths, OfDiagonalBandsAreTheirPixelsOverTheirLength) {
    // n diagonals of pixels: n pixels for each sqrt(2) px along.
    for (const int n : {1, 2, 3, 5}) {
        const auto band = drawn_where(300, 300, [&](double x, double y) {
            const double k = std::round(x - y);
            return k >= -(n / 2) && k < n - n / 2;
        });
        const Widths w = widths_of(band, {curve(20.3, 20.3, 280.3, 280.3)});
        EXPECT_EQ(w.all.n, 368);  // 260 sqrt(2) = 367.7
        EXPECT_NEAR(*w.all.mean(), n / std::sqrt(2), 0.01) << n;
    }
}

TEST(Widths, OfBandsAtSlopeOneHalfAreTheirPixelsOverTheirLength) {
    // x - 2 y takes each whole number; n of them: n pixels for each sqrt(5) px along.
    for (const int n : {2, 3, 5, 9}) {
        const auto band = drawn_where(400, 220, [&](double x, double y) {
            const double k = std::round(x - 2 * y + 0.5);
            return k >= -(n / 2) && k < n - n / 2;
        });
        const Widths w = widths_of(band, {curve(20.4, 10.5, 380.4, 190.5)});
        EXPECT_NEAR(*w.all.mean(), n / std::sqrt(5), 0.01) << n;
        EXPECT_EQ(w.n_missed, 0) << n;
    }
}

TEST(Widths, OfBandsDrawnAroundALineAreTheBandsOnAverage) {
    // All centres within half the width of a line at an odd angle.
    const Curves line = {curve(10.3, 20.7, 290.3, 150.7)};
    const double dx = 280 / std::hypot(280, 130), dy = 130 / std::hypot(280, 130);
    for (const double width : {1.0, 2.0, 3.0, 5.0, 9.0}) {
        const auto band = drawn_where(300, 180, [&](double x, double y) {
            return std::abs((x - 10.3) * dy - (y - 20.7) * dx) < width / 2;
        });
        EXPECT_NEAR(*widths_of(band, line).all.mean(), width, 0.03 * width) << width;
    }
}

TEST(Widths, AreThoseOfALineUpToTwoPixelsBeside) {
    const auto rows = [](int first, int last) {
        return drawn_where(60, 40, [&](double, double y) { return y > first && y < last + 1; });
    };
    const Curves line = {curve(10, 20.5, 50, 20.5)};
    EXPECT_DOUBLE_EQ(*widths_of(rows(22, 24), line).all.mean(), 3);  // begins 1.5 px below
    EXPECT_DOUBLE_EQ(*widths_of(rows(17, 18), line).all.mean(), 2);
    EXPECT_EQ(widths_of(rows(23, 25), line).n_missed, 40);  // 2.5 px
    // Of two the nearer: row 21 begins 0.5 px below, row 18 ends 1.5 px above.
    Image two = rows(21, 22);
    for (int x = 0; x < 60; ++x)
        two.at(x, 18) = 1;
    EXPECT_DOUBLE_EQ(*widths_of(two, line).all.mean(), 2);
}

TEST(Widths, OfAreasAndCrossingLinesAreLeftOut) {
    const Curves line = {curve(10, 20.5, 50, 20.5)};
    const Widths filled = widths_of(Image(60, 40, 1), line);
    EXPECT_EQ(filled.all.n, 0);
    EXPECT_EQ(filled.n_open, 40);
    // A line two rows wide that three columns cross.
    const auto cross = drawn_where(
        60, 40, [](double x, double y) { return (y > 20 && y < 22) || (x > 30 && x < 33); });
    const Widths w = widths_of(cross, line);
    EXPECT_EQ(w.n_open, 3);
    EXPECT_EQ(w.all.n, 37);
    EXPECT_DOUBLE_EQ(*w.all.mean(), 2);
}

TEST(Widths, AreProbedOncePerPixelOfLengthHoweverTheCurvesAreCut) {
    const auto rows = drawn_where(60, 40, [](double, double y) { return y > 20 && y < 21; });
    Curves pieces;
    for (int i = 0; i < 160; ++i)
        pieces.push_back(curve(10 + i * 0.25, 20.5, 10 + (i + 1) * 0.25, 20.5));
    EXPECT_EQ(widths_of(rows, pieces).all.n, 40);
    EXPECT_EQ(widths_of(rows, {curve(10, 20.5, 10.4, 20.5)}).all.n, 0);
}

TEST(Widths, AreKeptPerClassAndWithoutBandAndIgnore) {
    const auto rows = drawn_where(60, 40, [](double, double y) { return y > 20 && y < 22; });
    const Curves curves = {curve(0, 20.5, 30, 20.5, ink::truth::LineClass::contour),
                           curve(30, 21.5, 60, 21.5, ink::truth::LineClass::seam)};
    const ScoreOptions options{.band_px = 6, .ignore_label = 7};
    Image labels(60, 40);
    for (int x = 50; x < 60; ++x)
        labels.at(x, 21) = 7;
    const auto truth = prepare_truth(labels, options, false);
    const Widths w = measure_widths(rows, place_probes(curves, truth, options));
    EXPECT_EQ(w.classes[1].n, 24);
    EXPECT_EQ(w.classes[5].n, 20);
    EXPECT_EQ(w.all.n, 44);
}

TEST(Widths, OfNothingAreNoNumber) {
    const Widths undrawn = widths_of(Image(60, 40), {curve(10, 20.5, 50, 20.5)});
    EXPECT_EQ(undrawn.n_missed, 40);
    EXPECT_FALSE(undrawn.all.mean().has_value());
    EXPECT_FALSE(undrawn.all.spread().has_value());
    EXPECT_FALSE(widths_of(Image(60, 40, 1), {}).all.mean().has_value());
}

}  // namespace
