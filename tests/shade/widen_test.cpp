#include "shade/compose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ink::shade {
namespace {

using Strengths = core::Image<std::uint8_t>;

/// A single pixel in the middle of 7 x 7, widened: rows of '.' and '#'.
std::vector<std::string> disc(int diameter_px) {
    Strengths dot(7, 7);
    dot.at(3, 3) = 200;
    const Strengths result = widen(dot, diameter_px);
    std::vector<std::string> rows;
    for (int y = 0; y < 7; ++y) {
        std::string row;
        for (int x = 0; x < 7; ++x)
            row += result.at(x, y) == 200 ? '#' : '.';
        rows.push_back(row);
    }
    return rows;
}

TEST(Widen, MakesDiscs) {
    const std::string none = ".......";
    EXPECT_EQ(disc(1), (std::vector<std::string>{none, none, none, "...#...", none, none, none}));
    EXPECT_EQ(disc(2),
              (std::vector<std::string>{none, none, "..##...", "..##...", none, none, none}));
    EXPECT_EQ(disc(3),
              (std::vector<std::string>{none, none, "..###..", "..###..", "..###..", none, none}));
    EXPECT_EQ(
        disc(4),
        (std::vector<std::string>{none, "..##...", ".####..", ".####..", "..##...", none, none}));
    EXPECT_EQ(disc(5),
              (std::vector<std::string>{
                  none, "..###..", ".#####.", ".#####.", ".#####.", "..###..", none}));
}

TEST(Widen, ALineOfOnePixelGetsTheDiameterAsItsWidth) {
    Strengths line(40, 40);
    for (int y = 0; y < 40; ++y)
        line.at(20, y) = 255;
    for (int diameter = 1; diameter < 12; ++diameter) {
        const Strengths result = widen(line, diameter);
        const std::uint8_t* row = result.row(20);
        EXPECT_EQ(std::count(row, row + 40, 255), diameter);
    }
}

TEST(Widen, TheStrongestWinsAndTheBorderCuts) {
    Strengths edge_responses(3, 1);
    edge_responses.at(0, 0) = 90;
    edge_responses.at(2, 0) = 10;
    const Strengths result = widen(edge_responses, 3);
    EXPECT_EQ(result.at(0, 0), 90);
    EXPECT_EQ(result.at(1, 0), 90);
    EXPECT_EQ(result.at(2, 0), 10);
    EXPECT_TRUE(widen({}, 5).is_empty());
}

}  // namespace
}  // namespace ink::shade
