#include "raster/lines/line_steps.h"

#include <gtest/gtest.h>

#include <random>

#include "line_reference.h"

namespace ink::raster {
namespace {

ScreenVertex at(std::int32_t x, std::int32_t y) {
    return {.x = x, .y = y};
}

/// What LineSteps tells, as pixels; every pixel must come once.
std::set<Pixel> stepped_line(const ScreenVertex& a,
                             const ScreenVertex& b,
                             int width_px,
                             bool is_both_ways = false) {
    LineSteps steps(a, b, width_px, is_both_ways);
    std::set<Pixel> result;
    if (steps.begin() >= steps.end()) return result;
    steps.start(steps.begin());
    for (int step = steps.begin(); step < steps.end(); ++step, steps.advance()) {
        for (int i = steps.first(); i < steps.first() + width_px; ++i) {
            const Pixel pixel = steps.is_x_major() ? Pixel{step, i} : Pixel{i, step};
            EXPECT_TRUE(result.insert(pixel).second);
        }
    }
    return result;
}

void expect_as_reference(const ScreenVertex& a, const ScreenVertex& b) {
    for (int width_px = 1; width_px <= 5; ++width_px) {
        EXPECT_EQ(stepped_line(a, b, width_px), reference_line(a, b, width_px))
            << a.x << ',' << a.y << " to " << b.x << ',' << b.y << " width " << width_px;
        auto both = reference_line(a, b, width_px);
        both.merge(reference_line(b, a, width_px));
        EXPECT_EQ(stepped_line(a, b, width_px, true), both)
            << a.x << ',' << a.y << " and " << b.x << ',' << b.y << " width " << width_px;
    }
}

/// From one place 21 px away in directions all round: 64 of them hold the axes and the diagonals.
TEST(LineSteps, CoverAllOctantsAsTheDiamondExitRuleSays) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> any(-256, 256);
    for (int around = 0; around < 64; ++around) {
        const int side = around / 16;
        const int along = (around % 16 - 8) * 21 * 32;
        const int out = 21 * 256;
        const int dx[] = {out, -along, -out, along};
        const int dy[] = {along, out, -along, -out};
        const ScreenVertex a = at(10 * 256 + any(random), 10 * 256 + any(random));
        expect_as_reference(a, at(a.x + dx[side], a.y + dy[side]));
    }
}

/// Centres, corners and middles of sides of pixels and the corners and sides of diamonds, where
/// only the rule for ties decides; lines of all lengths from none.
TEST(LineSteps, DecideTiesAsTheDiamondExitRuleSays) {
    for (int ax = 0; ax <= 256; ax += 64) {
        for (int ay = 0; ay <= 256; ay += 64) {
            for (int bx = -384; bx <= 640; bx += 64) {
                for (int by = -384; by <= 640; by += 64)
                    expect_as_reference(at(ax, ay), at(bx, by));
            }
        }
    }
}

TEST(LineSteps, CoverRandomShortLinesAsTheDiamondExitRuleSays) {
    std::mt19937 random(2);
    std::uniform_int_distribution<int> any(-1500, 1500);
    for (int i = 0; i < 2000; ++i)
        expect_as_reference(at(any(random), any(random)), at(any(random), any(random)));
}

/// Counted by hand: from the centre of pixel (2, 3) to that of (6, 3), which is not drawn.
TEST(LineSteps, LeaveOutTheirLastPixel) {
    const auto line =
        stepped_line(at(2 * 256 + 128, 3 * 256 + 128), at(6 * 256 + 128, 3 * 256 + 128), 1);
    EXPECT_EQ(line, (std::set<Pixel>{{2, 3}, {3, 3}, {4, 3}, {5, 3}}));
}

/// Width 2, level, through the centres of row 3: moved down by half a pixel it runs between rows 3
/// and 4, OpenGL takes the lower one, and draws upwards from there.
TEST(LineSteps, GrowUpwardsFromALevelLine) {
    const auto line = stepped_line(at(128, 3 * 256 + 128), at(256 + 128, 3 * 256 + 128), 2);
    EXPECT_EQ(line, (std::set<Pixel>{{0, 3}, {0, 4}}));
}

/// Steep, through the centres of column 3: moved left by half a pixel it runs between columns 2 and
/// 3, OpenGL takes the left one, and draws to the right.
TEST(LineSteps, GrowToTheRightFromASteepLine) {
    const auto line = stepped_line(at(3 * 256 + 128, 128), at(3 * 256 + 128, 256 + 128), 2);
    EXPECT_EQ(line, (std::set<Pixel>{{2, 0}, {3, 0}}));
}

}  // namespace
}  // namespace ink::raster
