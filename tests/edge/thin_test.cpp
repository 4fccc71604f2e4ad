#include "edge/thin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "guarded.h"

namespace {

using ink::edge::EdgeImage;
using ink::edge::Mask;
using ink::edge::on_every_target;
using ink::edge::thin;
using Rows = std::vector<std::string>;

Mask mask_of(const Rows& rows) {
    Mask mask(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
    for (int y = 0; y < mask.height_px(); ++y) {
        for (int x = 0; x < mask.width_px(); ++x) {
            mask.at(x, y) = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#';
        }
    }
    return mask;
}

Rows rows_of(const Mask& mask) {
    Rows rows(static_cast<std::size_t>(mask.height_px()));
    for (int y = 0; y < mask.height_px(); ++y) {
        for (int x = 0; x < mask.width_px(); ++x) {
            rows[static_cast<std::size_t>(y)] += mask.at(x, y) != 0 ? '#' : '.';
        }
    }
    return rows;
}

Mask random_mask(int width_px, int height_px, double share, std::mt19937& random) {
    Mask mask(width_px, height_px);
    std::bernoulli_distribution is_set(share);
    for (int y = 0; y < height_px; ++y) {
        for (int x = 0; x < width_px; ++x)
            mask.at(x, y) = is_set(random);
    }
    return mask;
}

bool is_set(const Mask& mask, int x, int y) {
    return mask.contains(x, y) && mask.at(x, y) != 0;
}

/// The paper's conditions word for word, for one pixel; x[1]..x[8] counter-clockwise from the
/// right.
bool goes(const Mask& m, int px, int py, bool is_second) {
    constexpr std::array<int, 9> kX = {0, 1, 1, 0, -1, -1, -1, 0, 1};
    constexpr std::array<int, 9> kY = {0, 0, -1, -1, -1, 0, 1, 1, 1};
    std::array<bool, 10> x{};
    for (std::size_t i = 1; i <= 8; ++i)
        x[i] = is_set(m, px + kX[i], py + kY[i]);
    x[9] = x[1];
    int crossings = 0;
    int n1 = 0;
    int n2 = 0;
    for (std::size_t k = 1; k <= 4; ++k) {
        crossings += !x[2 * k - 1] && (x[2 * k] || x[2 * k + 1]);
        n1 += x[2 * k - 1] || x[2 * k];
        n2 += x[2 * k] || x[2 * k + 1];
    }
    const bool g3 =
        is_second ? !((x[6] || x[7] || !x[4]) && x[5]) : !((x[2] || x[3] || !x[8]) && x[1]);
    return crossings == 1 && std::min(n1, n2) >= 2 && std::min(n1, n2) <= 3 && g3;
}

/// Full passes over the whole image until nothing goes.
Mask thin_by_passes(Mask mask) {
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (const bool is_second : {false, true}) {
            Mask next = mask;
            for (int y = 0; y < mask.height_px(); ++y) {
                for (int x = 0; x < mask.width_px(); ++x) {
                    if (is_set(mask, x, y) && goes(mask, x, y, is_second)) next.at(x, y) = 0;
                }
            }
            has_changed = has_changed || next != mask;
            mask = next;
        }
    }
    return mask;
}

int count_components(Mask mask) {
    int pieces = 0;
    std::vector<std::pair<int, int>> front;
    for (int y = 0; y < mask.height_px(); ++y) {
        for (int x = 0; x < mask.width_px(); ++x) {
            if (!is_set(mask, x, y)) continue;
            ++pieces;
            front = {{x, y}};
            while (!front.empty()) {
                const auto [cx, cy] = front.back();
                front.pop_back();
                if (!is_set(mask, cx, cy)) continue;
                mask.at(cx, cy) = 0;
                for (int i = 0; i < 9; ++i)
                    front.emplace_back(cx + i % 3 - 1, cy + i / 3 - 1);
            }
        }
    }
    return pieces;
}

// The expected images of the next tests are what scikit-image 0.19 makes of them.

TEST(Thin, MakesABlockASpine) {
    EXPECT_EQ(rows_of(thin(mask_of({"######",  //
                                    "######",
                                    "######",
                                    "######"}))),
              (Rows{"......",  //
                    "......",
                    ".###..",
                    "......"}));
}

TEST(Thin, MakesAThickDiagonalSingle) {
    EXPECT_EQ(rows_of(thin(mask_of(
                  {"##......", ".##.....", "..##....", "...##...", "....##..", ".....##."}))),
              (Rows{"#.......", ".#......", "..#.....", "...#....", "....#...", ".....##."}));
}

TEST(Thin, KeepsTheHoleOfAThickRing) {
    EXPECT_EQ(rows_of(thin(mask_of(
                  {"#########", "#########", "##.....##", "##.....##", "#########", "#########"}))),
              (Rows{".........", ".######..", "#......#.", "#......#.", ".#.....#.", "..#####.."}));
}

TEST(Thin, LeavesThinThingsAlone) {
    for (const Rows& rows : {Rows{"#"},
                             Rows{"#", "#", "#"},
                             Rows{"#.#", ".#.", "#.#"},
                             Rows{".###.", "#...#", "#...#", ".###."},
                             Rows{"....", "...."}}) {
        EXPECT_EQ(rows_of(thin(mask_of(rows))), rows);
    }
}

TEST(Thin, OfAnEmptyMaskIsEmpty) {
    EXPECT_TRUE(thin(Mask()).is_empty());
}

TEST(Thin, EqualsFullPassesOnRandomMasks) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> side_px(1, 24);
    for (int i = 0; i < 300; ++i) {
        const double share = (i % 10 + 0.5) / 10;
        const Mask mask = random_mask(side_px(random), side_px(random), share, random);
        const Rows expected = rows_of(thin_by_passes(mask));
        on_every_target([&] { ASSERT_EQ(rows_of(thin(mask)), expected) << "mask " << i; });
    }
}

TEST(Thin, EqualsFullPassesAcrossTheBordersOfWordsAndBlocks) {
    std::mt19937 random(10);
    for (const int width_px : {63, 64, 65, 128, 190, 448, 700}) {
        for (int i = 0; i < 20; ++i) {
            const double share = (i % 10 + 0.5) / 10;
            const Mask mask = random_mask(width_px, 9, share, random);
            const Rows expected = rows_of(thin_by_passes(mask));
            on_every_target([&] { ASSERT_EQ(rows_of(thin(mask)), expected) << "mask " << i; });
        }
        const Mask full(width_px, 12, 1);
        const Rows expected = rows_of(thin_by_passes(full));
        on_every_target([&] { ASSERT_EQ(rows_of(thin(full)), expected) << width_px; });
    }
}

TEST(BitMask, GivesItsMaskBack) {
    std::mt19937 random(11);
    for (const int width_px : {1, 7, 8, 9, 63, 64, 65, 130}) {
        const Mask mask = random_mask(width_px, 3, 0.4, random);
        on_every_target(
            [&] { EXPECT_EQ(rows_of(ink::edge::BitMask(mask).bytes()), rows_of(mask)); });
        const ink::edge::BitMask bits(mask);
        ink::edge::BitMask set(width_px, 3);
        for (int y = 0; y < 3; ++y) {
            int next = 0;
            bits.visit_row(y, [&](int x) {
                for (; next < x; ++next)
                    EXPECT_EQ(mask.at(next, y), 0);
                EXPECT_EQ(mask.at(next++, y), 1);
                set.set(x, y);
            });
            for (; next < width_px; ++next)
                EXPECT_EQ(mask.at(next, y), 0);
            for (int x = 0; x < width_px; ++x)
                EXPECT_EQ(set.is_set(x, y), mask.at(x, y) == 1);
        }
    }
}

TEST(Thin, KeepsEveryPieceInOnePiece) {
    std::mt19937 random(9);
    for (int i = 0; i < 200; ++i) {
        const Mask mask = random_mask(25, 25, (i % 10 + 0.5) / 10, random);
        ASSERT_EQ(count_components(thin(mask)), count_components(mask)) << "mask " << i;
    }
}

TEST(Threshold, PercentsAreTheLeastResponseThatReachesThem) {
    EXPECT_EQ(ink::edge::response_at_percent(1), 3);    // 255 / 100 = 2.55
    EXPECT_EQ(ink::edge::response_at_percent(20), 51);  // exactly 51
    EXPECT_EQ(ink::edge::response_at_percent(99), 253);
    for (int k = 1; k <= 99; ++k) {
        const int edge_response = ink::edge::response_at_percent(k);
        EXPECT_GE(edge_response * 100, 255 * k);
        EXPECT_LT((edge_response - 1) * 100, 255 * k);
    }
}

}  // namespace
