#include "shade/line_chains.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/score/images.h"

namespace ink::shade {
namespace {

/// 1 where the text has '#'.
Image mask_of(const Rows& rows) {
    Image mask = image_of(rows);
    for (std::size_t i = 0; i < mask.size(); ++i)
        mask.data()[i] = mask.data()[i] == 255;
    return mask;
}

using Points = std::vector<glm::dvec2>;

TEST(TraceChains, ALineIsOneChainThroughPixelCentres) {
    const auto chains = trace_chains(mask_of({"......", ".##...", "...##.", "......"}));
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_FALSE(chains[0].is_closed);
    EXPECT_EQ(chains[0].points_px, (Points{{1.5, 1.5}, {2.5, 1.5}, {3.5, 2.5}, {4.5, 2.5}}));
}

TEST(TraceChains, ARingIsClosedAndDoesNotRepeatItsFirst) {
    const auto chains = trace_chains(mask_of({".##.", "#..#", "#..#", ".##."}));
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_TRUE(chains[0].is_closed);
    EXPECT_EQ(chains[0].points_px.size(), 8U);
}

TEST(TraceChains, AForkEndsItsThreeBranches) {
    const auto chains = trace_chains(mask_of({"#...#", ".#.#.", "..#..", "..#..", "..#.."}));
    ASSERT_EQ(chains.size(), 3U);
    for (const LineChain& chain : chains) {
        EXPECT_EQ(chain.points_px.size(), 3U);
        EXPECT_TRUE(chain.points_px.front() == glm::dvec2(2.5, 2.5) ||
                    chain.points_px.back() == glm::dvec2(2.5, 2.5));
    }
}

TEST(TraceChains, ACornerIsNotCutShort) {
    // The pixels beside the corner touch, but are joined over it.
    const auto chains = trace_chains(mask_of({"##", "#.", "#."}));
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_EQ(chains[0].points_px, (Points{{1.5, 0.5}, {0.5, 0.5}, {0.5, 1.5}, {0.5, 2.5}}));
}

TEST(TraceChains, SinglePixelsAndNothingGiveNothing) {
    EXPECT_TRUE(trace_chains(mask_of({"#..", "..#"})).empty());
    EXPECT_TRUE(trace_chains({}).empty());
}

TEST(CutAtCorners, ASquareBecomesFourSidesThatMeet) {
    LineChain square;
    square.is_closed = true;
    for (int i = 0; i < 20; ++i)
        square.points_px.emplace_back(i, 0);
    for (int i = 0; i < 20; ++i)
        square.points_px.emplace_back(20, i);
    for (int i = 0; i < 20; ++i)
        square.points_px.emplace_back(20 - i, 20);
    for (int i = 0; i < 20; ++i)
        square.points_px.emplace_back(0, 20 - i);
    const auto pieces = cut_at_corners({square}, std::numbers::pi / 4, 4);
    ASSERT_EQ(pieces.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_FALSE(pieces[i].is_closed);
        EXPECT_EQ(pieces[i].points_px.back(), pieces[(i + 1) % 4].points_px.front());
        EXPECT_EQ(pieces[i].points_px.size(), 21U);
    }
}

TEST(CutAtCorners, ACircleStaysWhole) {
    LineChain circle;
    circle.is_closed = true;
    for (int i = 0; i < 120; ++i) {
        const double turn = 2 * std::numbers::pi * i / 120;
        circle.points_px.emplace_back(20 * std::cos(turn), 20 * std::sin(turn));
    }
    const auto pieces = cut_at_corners({circle}, std::numbers::pi / 4, 4);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_TRUE(pieces[0].is_closed);
}

TEST(Smooth, TakesTheStepsOutOfARasterLineAndKeepsItsEnds) {
    LineChain line;
    for (int i = 0; i <= 60; ++i)
        line.points_px.emplace_back(i, std::floor(i / 3.0));
    const glm::dvec2 first = line.points_px.front();
    const glm::dvec2 last = line.points_px.back();
    smooth(line, 3);
    EXPECT_EQ(line.points_px.front(), first);
    EXPECT_EQ(line.points_px.back(), last);
    for (std::size_t i = 15; i <= 45; ++i) {
        const glm::dvec2& p = line.points_px[i];
        EXPECT_NEAR(p.y, (p.x - 1) / 3, 0.02);  // steps lie 1/3 below y = x/3 on average
    }
}

TEST(Smooth, ByNothingChangesNothing) {
    LineChain line{{{0, 0}, {1, 5}, {2, 0}}, false};
    smooth(line, 0);
    EXPECT_EQ(line.points_px, (Points{{0, 0}, {1, 5}, {2, 0}}));
}

}  // namespace
}  // namespace ink::shade
