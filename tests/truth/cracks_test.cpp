#include "truth/cracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/truth/shapes.h"

namespace ink::truth {
namespace {

using Flags = core::Image<std::uint8_t>;

Curve line(double x0, double y0, double x1, double y1, LineClass c = LineClass::contour) {
    return {.line_class = c, .begin = {x0, y0, 1}, .end = {x1, y1, 1}};
}

Cracks cracks_of(const std::vector<Curve>& curves, int width_px = 16, int height_px = 12) {
    return draw_cracks(curves, width_px, height_px);
}

std::ptrdiff_t count(const Flags& flags) {
    return std::count_if(flags.data(), flags.data() + flags.size(), [](auto v) { return v != 0; });
}

/// The columns x of row y in which `flags` is set.
std::vector<int> columns_of(const Flags& flags, int y) {
    std::vector<int> columns;
    for (int x = 0; x < flags.width_px(); ++x) {
        if (flags.at(x, y) != 0) columns.push_back(x);
    }
    return columns;
}

TEST(Cracks, OfASlopedLineAreOneARowAndOneAColumn) {
    // y = 1.1 + (x - 1.3) / 2 over 12 columns of centres and 6 rows of them.
    const Cracks cracks = cracks_of({line(1.3, 1.1, 13.3, 7.1)});
    EXPECT_EQ(count(cracks.below), 12);
    EXPECT_EQ(count(cracks.right), 6);
    for (int y = 1; y < 7; ++y) {
        const double x = 1.3 + 2 * (y + 0.5 - 1.1);
        EXPECT_EQ(columns_of(cracks.right, y),
                  std::vector<int>{static_cast<int>(std::floor(x - 0.5))});
    }
    for (int x = 1; x < 13; ++x) {
        const double y = 1.1 + (x + 0.5 - 1.3) / 2;
        EXPECT_NE(cracks.below.at(x, static_cast<int>(std::floor(y - 0.5))), 0) << x;
    }
}

TEST(Cracks, OfALineThroughCentresLieOnTheSideTheRuleNames) {
    // Straight down through the centres of column 5: they lie to its right.
    const Cracks down = cracks_of({line(5.5, 2, 5.5, 9)});
    for (int y = 2; y < 9; ++y)
        EXPECT_EQ(columns_of(down.right, y), std::vector<int>{4});
    EXPECT_EQ(count(down.below), 0);
    // Level through the centres of row 5: they lie below it.
    const Cracks level = cracks_of({line(3, 5.5, 9, 5.5)});
    for (int x = 3; x < 9; ++x)
        EXPECT_NE(level.below.at(x, 4), 0);
    EXPECT_EQ(count(level.below), 6);
    EXPECT_EQ(count(level.right), 0);
    // Down to the right through (2, 2) .. (7, 7): as if moved to the left, centres lie above it.
    const Cracks falling = cracks_of({line(2, 2, 8, 8)});
    EXPECT_EQ(count(falling.right), 6);
    EXPECT_EQ(count(falling.below), 6);
    for (int i = 2; i < 8; ++i) {
        EXPECT_NE(falling.right.at(i - 1, i), 0) << i;
        EXPECT_NE(falling.below.at(i, i), 0) << i;
    }
    // Up to the right through (2, 7) .. (7, 2): moved to the left, centres lie below it.
    const Cracks rising = cracks_of({line(2, 8, 8, 2)});
    for (int i = 2; i < 8; ++i) {
        EXPECT_NE(rising.right.at(i - 1, 9 - i), 0) << i;
        EXPECT_NE(rising.below.at(i, 8 - i), 0) << i;
    }
    EXPECT_EQ(count(rising.right) + count(rising.below), 12);
}

TEST(Cracks, DoNotDependOnTheDirectionOfACurve) {
    Noise noise(5);
    for (int i = 0; i < 400; ++i) {
        const auto at = [&](double scale) {
            // Every other one lies on centres and corners of pixels.
            const double v = noise.next() * scale;
            return i % 2 == 0 ? v : std::round(2 * v) / 2;
        };
        const double x0 = at(16), y0 = at(12), x1 = at(16), y1 = at(12);
        const Cracks there = cracks_of({line(x0, y0, x1, y1)});
        const Cracks back = cracks_of({line(x1, y1, x0, y0)});
        ASSERT_EQ(there.right, back.right) << i;
        ASSERT_EQ(there.below, back.below) << i;
    }
}

TEST(Cracks, OfPiecesEndToEndAreThoseOfTheWhole) {
    // Cut at a centre, at a corner and on the way: nothing is crossed twice or left out.
    const Cracks whole = cracks_of({line(1.5, 2.5, 13.5, 8.5)});
    const Cracks cut = cracks_of({line(1.5, 2.5, 3.5, 3.5),
                                  line(5, 4.25, 3.5, 3.5),
                                  line(5, 4.25, 8, 5.75),
                                  line(8, 5.75, 13.5, 8.5)});
    EXPECT_EQ(count(whole.right) + count(whole.below), 6 + 12);
    EXPECT_EQ(whole.right, cut.right);
    EXPECT_EQ(whole.below, cut.below);
}

/// How often curves cross the ring of segments through the centres of a 2x2 block of pixels.
int crossings_of_ring(const Cracks& cracks, int x, int y) {
    return (cracks.right.at(x, y) != 0) + (cracks.below.at(x, y) != 0) +
           (cracks.right.at(x, y + 1) != 0) + (cracks.below.at(x + 1, y) != 0);
}

TEST(Cracks, OfAClosedLinePartTheCentresInsideFromThoseOutside) {
    // A polygon whose corners lie on centres, corners and anywhere. Its inside, by crossings
    // counted along each row and along each column, is the same set of centres.
    std::vector<Curve> circle;
    const auto corner = [](int i) {
        const double turn = 2 * std::numbers::pi * i / 23;
        const double x = 20 + 13 * std::cos(turn), y = 16 + 11 * std::sin(turn);
        return i % 3 == 0 ? CurvePoint{x, y, 1}
                          : CurvePoint{std::floor(x) + (i % 3 == 1 ? 0.5 : 0.0),
                                       std::floor(y) + (i % 3 == 1 ? 0.5 : 0.0),
                                       1};
    };
    for (int i = 0; i < 23; ++i) {
        Curve curve = line(0, 0, 0, 0);
        curve.begin = corner(i);
        curve.end = corner((i + 1) % 23);
        circle.push_back(curve);
    }
    const Cracks cracks = draw_cracks(circle, 40, 32);
    Flags by_row(40, 32), by_column(40, 32);
    for (int y = 0; y < 32; ++y) {
        for (int x = 1; x < 40; ++x)
            by_row.at(x, y) = by_row.at(x - 1, y) != (cracks.right.at(x - 1, y) != 0);
    }
    for (int x = 0; x < 40; ++x) {
        for (int y = 1; y < 32; ++y)
            by_column.at(x, y) = by_column.at(x, y - 1) != (cracks.below.at(x, y - 1) != 0);
    }
    EXPECT_EQ(by_row, by_column);
    EXPECT_NEAR(static_cast<double>(count(by_row)), std::numbers::pi * 13 * 11, 30);
    for (int y = 0; y + 1 < 32; ++y) {
        for (int x = 0; x + 1 < 40; ++x)
            ASSERT_EQ(crossings_of_ring(cracks, x, y) % 2, 0) << x << " " << y;
    }
}

TEST(Cracks, TakeTheLowestClass) {
    const std::vector<Curve> curves = {line(5.2, 2, 5.2, 9, LineClass::crease),
                                       line(5.4, 4, 5.4, 6, LineClass::contour),
                                       line(4.8, 5, 4.8, 9, LineClass::seam)};
    const Cracks cracks = cracks_of(curves);
    const std::vector<int> expected = {0, 0, 3, 3, 1, 1, 3, 3, 3, 0, 0, 0};
    for (int y = 0; y < 12; ++y)
        EXPECT_EQ(cracks.right.at(4, y), expected[static_cast<std::size_t>(y)]) << y;
}

TEST(Cracks, AtTheFrameHaveTwoCentresInTheImage) {
    // Along the frame there is one centre only; across it the segments inside are crossed.
    EXPECT_EQ(count(cracks_of({line(0.2, 0, 0.2, 12)}).right), 0);
    EXPECT_EQ(count(cracks_of({line(15.7, 0, 15.7, 12)}).right), 0);
    EXPECT_EQ(count(cracks_of({line(0, 0.3, 16, 0.3)}).below), 0);
    EXPECT_EQ(count(cracks_of({line(0, 11.6, 16, 11.6)}).below), 0);
    EXPECT_EQ(count(cracks_of({line(0.6, 0, 0.6, 12)}).right), 12);
    EXPECT_EQ(count(cracks_of({line(15.5, 0, 15.5, 12)}).right), 12);
    const Cracks far = cracks_of({line(-1e6, 5.8, 1e6, 5.8), line(7.2, -1e5, 7.2, 1e5)});
    EXPECT_EQ(count(far.below), 16);
    EXPECT_EQ(count(far.right), 12);
    EXPECT_EQ(count(cracks_of({line(-50, 3, -2, 9)}).right), 0);
}

TEST(Cracks, OfNothingAreNone) {
    EXPECT_EQ(count(cracks_of({}).right), 0);
    EXPECT_EQ(count(cracks_of({line(3.5, 3.5, 3.5, 3.5)}).right), 0);
    EXPECT_TRUE(draw_cracks({}, 0, 0).right.is_empty());
}

TEST(Cracks, OfNearlyLevelLinesAreDecidedExactly) {
    // Over 600 px the line falls by the least that doubles can tell. It crosses the row's line of
    // centres between x = 300 and 301, though no product in double would say where.
    const double tiny = std::ldexp(1.0, -44);
    const Cracks cracks =
        draw_cracks(std::vector<Curve>{line(0.25, 100.5 - tiny, 600.25, 100.5 + tiny)}, 640, 200);
    EXPECT_EQ(columns_of(cracks.right, 100), std::vector<int>{299});
    EXPECT_EQ(count(cracks.right), 1);
    for (int x = 0; x < 600; ++x)
        ASSERT_NE(cracks.below.at(x, x <= 299 ? 99 : 100), 0) << x;
}

}  // namespace
}  // namespace ink::truth
